"""Wine of this machine's own Debian release, which starts Windows' programs, unpacked in .toolchain/wine."""

import shutil

from . import debian
from .place import make_folder

PACKAGES = ["wine64", "wine"]
REMEDY = "The suite `windows` needs Debian on x86_64: elsewhere leave it out."
UNNEEDED = ("usr/share/doc", "usr/share/man", "usr/share/locale", "usr/share/lintian", "usr/share/icons")


def fetch():
    """The folder .toolchain/wine."""
    return make_folder("wine", " ".join(PACKAGES), fill)


def fill(folder):
    debian.unpack("Wine", PACKAGES, folder, REMEDY, suite=debian.OWN)
    # It is a script that looks for the program in the system's folders.
    server = folder / "usr/lib/wine/wineserver"
    server.unlink(missing_ok=True)
    server.symlink_to("wineserver64")
    for unneeded in UNNEEDED:
        shutil.rmtree(folder / unneeded, ignore_errors=True)


def prepare(folder, prefix):
    """Makes the folder `prefix` for a Windows, with what the packages' own scripts would put there."""
    system = prefix / "drive_c/windows/system32"
    system.mkdir(parents=True)
    shutil.copy(folder / "usr/x86_64-w64-mingw32/lib/zlib1.dll", system)


def environment(folder, prefix, surroundings):
    """`surroundings` in which the programs of `folder` work, with their Windows in the folder `prefix`."""
    libraries = [str(path) for path in sorted(folder.glob("usr/lib/*-linux-gnu"))]
    return {**surroundings, "WINEPREFIX": str(prefix), "WINELOADER": str(folder / "usr/lib/wine/wine64"),
            "WINESERVER": str(server(folder)), "WINEDEBUG": "-all", "DISPLAY": "",
            "LD_LIBRARY_PATH": ":".join(libraries), "WINEDLLOVERRIDES": "mscoree,mshtml="}


def program(folder):
    """What starts a program for Windows."""
    return folder / "usr/lib/wine/wine64"


def server(folder):
    """Wine's server; ends with its programs, or on request."""
    return folder / "usr/lib/wine/wineserver64"
