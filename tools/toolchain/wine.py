"""Wine of this machine's own Debian release, which starts Windows' programs, unpacked in .toolchain/wine."""

import shutil

from . import debian
from .place import Missing, make_folder

PACKAGES = ["wine64", "wine"]
REMEDY = "The suite `windows` needs Debian on x86_64: elsewhere leave it out."
UNNEEDED = ("usr/share/doc", "usr/share/man", "usr/share/locale", "usr/share/lintian", "usr/share/icons")


def fetch():
    """The folder .toolchain/wine."""
    return make_folder("wine", " ".join(PACKAGES), fill)


def fill(folder):
    debian.unpack("Wine", PACKAGES, folder, REMEDY, suite=debian.OWN)
    # What the packages' own scripts would do.
    try:
        modules = next(folder.glob("usr/lib/*/wine/x86_64-windows"))
        shutil.copy(next(folder.glob("usr/x86_64-w64-mingw32/lib/zlib1.dll")), modules)
    except StopIteration:
        raise Missing(f"Debian's Wine has changed: its modules are not where they were.\n{REMEDY}") from None
    # It is a script that looks for the program in the system's folders.
    server = folder / "usr/lib/wine/wineserver"
    server.unlink(missing_ok=True)
    server.symlink_to("wineserver64")
    for unneeded in UNNEEDED:
        shutil.rmtree(folder / unneeded, ignore_errors=True)


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
    """What ends with the programs, or before, where it is asked to."""
    return folder / "usr/lib/wine/wineserver64"
