"""The add-on as a user gets it: unpacked from the zip."""

import re
import shutil
import zipfile

from building import project
from shipping import archive
from toolchain.place import Missing

from .engine import PROJECT
from .result import ROOT

COMPLAINT = re.compile(r"^(?:USER )?(?:SCRIPT )?(?:ERROR|WARNING): .*$", re.MULTILINE)
# Messages of the engine in a virtual display.
EXPECTED = ("WARNING: Could not set V-Sync mode", "WARNING: lavapipe is not a conformant vulkan implementation")


def newest_zip():
    """The zip for all platforms or the one of this machine, whichever was made last."""
    found = [path for path in (archive.place(), archive.place(is_for_all=False)) if path.exists()]
    if not found:
        raise Missing(f"There is no {archive.place().name}: say `./run package` first, or `./run package here=yes`")
    return max(found, key=lambda path: path.stat().st_mtime)


def unpack(folder):
    """Unpacks the zip in `folder`, as its addons/undergrowth."""
    folder.mkdir(parents=True, exist_ok=True)
    with zipfile.ZipFile(newest_zip()) as packed:
        packed.extractall(folder)


def make_project(folder, settings=""):
    """Creates an empty project in `folder` with the add-on from the zip, without editor files."""
    shutil.rmtree(folder, ignore_errors=True)
    unpack(folder)
    (folder / "project.godot").write_text(PROJECT + settings)
    return folder


def make_test_project(folder):
    """The same with the engine's tests, and with the lists of extensions and uids that an editor writes."""
    make_project(folder)
    (folder / "tests").mkdir()
    project.link(ROOT / "tests/engine", folder / "tests/engine")
    project.list_extensions(folder)
    project.list_uids(folder)
    return folder


def complaints(output, expected=EXPECTED):
    """Returns the errors and warnings of the engine."""
    return [line for line in COMPLAINT.findall(output) if not line.startswith(expected)]
