"""Godot 4.6 or newer: the one that GODOT names, the one on PATH, or Debian testing's in .toolchain/."""

import os
import re
import shutil
import subprocess
import sys

from . import debian
from .place import Missing, TOOLCHAIN, make_folder, say

OLDEST = (4, 6)
PACKAGES = [
    "godot", "fonts-dejavu-core",
    "libgl1-mesa-dri", "libglx-mesa0", "libgl1", "libegl-mesa0", "libegl1", "mesa-vulkan-drivers", "libvulkan1",
    # A display where there is none, and a window manager that keeps the editor's windows in place.
    "xvfb", "x11-xkb-utils", "xkb-data", "matchbox-window-manager",
]
REMEDY = ("Get Godot 4.6 or newer (godotengine.org, brew install godot, pacman -S godot) and say\n"
          "GODOT=/path/to/godot ./run …, or put it on PATH as `godot`.")

# One script for each program: it starts through the folder's own loader, since the programs need a newer C library
# than the machine may have. Everything is found from where the script itself lies.
WRAPPER = """#!/bin/sh
root=$(dirname "$(dirname "$(readlink -f "$0")")")/godot
lib=$root/usr/lib/@TRIPLET@
@ENVIRONMENT@
exec "$root/@LOADER@" --library-path "$lib:$lib/pulseaudio:$lib/blas:$lib/lapack" "$root/usr/bin/@PROGRAM@" @OPTIONS@"$@"
"""
DRAWING = """export LIBGL_DRIVERS_PATH="$lib/dri" VK_DRIVER_FILES="$root/usr/share/vulkan/icd.d/lvp_icd.json"
export __EGL_VENDOR_LIBRARY_DIRS="$root/usr/share/glvnd/egl_vendor.d"
export XKB_CONFIG_ROOT="$root/@XKB@" XLOCALEDIR="$root/usr/share/X11/locale"
[ -e /etc/fonts/fonts.conf ] || export FONTCONFIG_FILE="$root/fonts.conf\""""
FONTS = """<?xml version="1.0"?>
<!DOCTYPE fontconfig SYSTEM "fonts.dtd">
<fontconfig><dir prefix="relative">usr/share/fonts</dir><cachedir prefix="xdg">fontconfig</cachedir></fontconfig>
"""


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
    programs = TOOLCHAIN / "bin"
    if not (programs / "godot").exists() or (programs / "godot").stat().st_mtime < folder.stat().st_mtime:
        write_wrappers(folder, programs)
    return programs / "godot"


def fill(folder):
    debian.unpack("Godot", PACKAGES, folder, REMEDY)
    for unneeded in ("usr/share/doc", "usr/share/man", "usr/share/locale", "usr/share/lintian"):
        shutil.rmtree(folder / unneeded, ignore_errors=True)
    (folder / "fonts.conf").write_text(FONTS)
    find_xkbcomp_on_path(folder / "usr/bin/Xvfb")


def find_xkbcomp_on_path(server):
    """Lets the private X server find its keymap compiler through PATH.

    Its folder is compiled in as /usr/bin. Emptying that text leaves the bare name, which the shell looks up.
    """
    data = server.read_bytes()
    if data.count(b"\0/usr/bin\0") != 1:
        raise Missing("Debian's Xvfb has changed: the folder of its keymap compiler is not where it was.\n"
                      "Install Xvfb (apt install xvfb) and Godot 4.6 yourself.\n" + REMEDY)
    server.write_bytes(data.replace(b"\0/usr/bin\0", b"\0\0usr/bin\0"))


def write_wrappers(folder, programs):
    loader = next(iter(sorted(folder.glob("usr/lib*/ld-linux*.so*"))))
    libraries = next(path.parent for path in folder.glob("usr/lib/*/libc.so.6"))
    xkb = next(path for path in ("usr/share/X11/xkb", "usr/share/xkeyboard-config-2") if (folder / path / "rules").is_dir())
    values = {"LOADER": str(loader.relative_to(folder)), "TRIPLET": libraries.name}
    programs.mkdir(exist_ok=True)
    for program, environment, options in (
            ("Xvfb", 'export PATH="$(dirname "$(readlink -f "$0")"):$PATH" LIBGL_DRIVERS_PATH="$lib/dri"',
             f'-xkbdir "$root/{xkb}" '),
            ("xkbcomp", "", f'-I"$root/{xkb}" '),
            ("matchbox-window-manager", "", ""),
            ("godot", DRAWING.replace("@XKB@", xkb), "")):
        text = WRAPPER.replace("@ENVIRONMENT@", environment).replace("@OPTIONS@", options).replace("@PROGRAM@", program)
        for name, value in values.items():
            text = text.replace(f"@{name}@", value)
        (programs / program).write_text(text)
        (programs / program).chmod(0o755)
