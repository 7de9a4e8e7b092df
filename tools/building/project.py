"""What a Godot project needs to find the add-on: a link to it, and its name in the list of extensions."""

import os
import re
import shutil
import struct
import subprocess
from pathlib import Path

EXTENSION = "res://addons/undergrowth/undergrowth.gdextension"
UID = re.compile(r"uid://([a-y0-8]+)")
UID_DIGITS = "abcdefghijklmnopqrstuvwxy012345678"


def link(target, place):
    """Makes `place` lead to the folder `target`: a link, on Windows a junction, else a copy."""
    target, place = Path(target), Path(place)
    if place.is_symlink() or place.exists():
        return
    try:
        place.symlink_to(os.path.relpath(target, place.parent), target_is_directory=True)
    except OSError:
        if subprocess.run(["cmd", "/c", "mklink", "/J", str(place), str(target)]).returncode != 0:
            shutil.copytree(target, place)


def list_extensions(project, extensions=(EXTENSION,)):
    """Writes the project's list of extensions if there is none.

    Without it the engine finds the extension during the first import, and crashes when that import ends.
    """
    path = Path(project) / ".godot/extension_list.cfg"
    if not path.exists():
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text("".join(line + "\n" for line in extensions))


def find_uids(addons):
    """The uid of each file of the folder `addons` that has one, by its path in the project."""
    found = {}
    for path in sorted(Path(addons).rglob("*")):
        if path.suffix in (".tres", ".tscn", ".uid"):
            uid = UID.search(path.read_text().partition("\n")[0])
            named = path.with_suffix("") if path.suffix == ".uid" else path
            if uid:
                found["res://addons/" + named.relative_to(addons).as_posix()] = uid[1]
    return found


def list_uids(project, addons):
    """Writes the project's cache of uids if there is none. An import makes one; a project without it warns of each."""
    cache = Path(project) / ".godot/uid_cache.bin"
    if cache.exists():
        return
    uids = find_uids(addons)
    entries = [struct.pack("<I", len(uids))]
    for path, text in uids.items():
        number = 0
        for digit in text:
            number = number * len(UID_DIGITS) + UID_DIGITS.index(digit)
        name = path.encode()
        entries.append(struct.pack("<QI", number & (2**63 - 1), len(name)) + name)
    cache.parent.mkdir(parents=True, exist_ok=True)
    cache.write_bytes(b"".join(entries))


def prepare(project, addons):
    """Everything for the project folder `project` and the folder `addons`."""
    if Path(project).is_dir():
        link(addons, Path(project) / "addons")
        list_extensions(project)
        list_uids(project, addons)
