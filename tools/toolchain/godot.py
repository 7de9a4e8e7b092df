"""Godot 4.6 or newer: the one that GODOT names, the one on PATH, or Debian testing's in .toolchain/."""

import os
import re
import shutil
import subprocess
import sys

from . import debian, unpacked
from .place import Missing, TOOLCHAIN, make_folder, say

OLDEST = (4, 6)
PACKAGES = [
    "godot", "fonts-dejavu-core",
    "libgl1-mesa-dri", "libglx-mesa0", "libgl1", "libegl-mesa0", "libegl1", "mesa-vulkan-drivers", "libvulkan1",
    # A display where there is none, and a window manager that keeps the editor's windows in place.
    "xvfb", "x11-xkb-utils", "xkb-data", "matchbox-window-manager",
    "patchelf",
]
REMEDY = ("Get Godot 4.6 or newer (godotengine.org, brew install godot, pacman -S godot) and say\n"
          "GODOT=/path/to/godot ./run …, or put it on PATH as `godot`.")

def parse_version(text):
    """(major, minor) from what `godot --version` prints; None where it is no version."""
    found = re.search(r"^(\d+)\.(\d+)[.\-]", text, re.MULTILINE)
    return (int(found.group(1)), int(found.group(2))) if found else None


def version_of(program):
    """The version of a Godot program; None where it does not start."""
    try:
        answer = subprocess.run([program, "--version"], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True,
                                stdin=subprocess.DEVNULL, timeout=60)
    except (OSError, subprocess.TimeoutExpired):
        return None
    return parse_version(answer.stdout)


def find():
    """The path of a Godot that is new enough, fetched if need be."""
    named = os.environ.get("GODOT")
    if named:
        program = shutil.which(named)
        version = version_of(program) if program else None
        if not version or version < OLDEST:
            found = "{}.{}".format(*version) if version else "nothing that answers --version"
            raise Missing(f"GODOT={named} is {found}, Godot 4.6 or newer is needed.\n{REMEDY}")
        return os.path.abspath(program)
    own = shutil.which("godot")
    if own:
        version = version_of(own)
        if version and version >= OLDEST:
            return own
        say(f"{own} is too old (4.6 is needed)")
    return str(fetch())


def fetch():
    """Debian's Godot in .toolchain/godot and the scripts that start it in .toolchain/bin; returns the script."""
    if not sys.platform.startswith("linux"):
        raise Missing(f"Godot 4.6 or newer is missing.\n{REMEDY}")
    folder = make_folder("godot", " ".join(PACKAGES), fill)
    texts = unpacked.wrappers(folder)
    return make_folder("bin", "\n".join(texts.values()), lambda new: unpacked.write_programs(texts, new)) / "godot"


def fill(folder):
    debian.unpack("Godot", PACKAGES, folder, REMEDY)
    unpacked.find_xkbcomp_on_path(folder / "usr/bin/Xvfb")
    unpacked.give_own_loader(folder, TOOLCHAIN / "godot", "usr/bin/godot")
    unpacked.shed_weight(folder)
