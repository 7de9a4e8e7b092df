"""Programs for Linux on arm64, started by qemu: Debian testing's Godot for that processor, in .toolchain/arm64."""

import shutil

from . import debian, unpacked
from .place import Missing, make_folder

GODOT = ["godot"]
QEMU = ["qemu-user-static"]
NAMES = ("qemu-aarch64-static", "qemu-aarch64")
REMEDY = "The suite `arm64` needs Debian on x86_64: elsewhere leave it out."


def fetch():
    """(words that start a program for arm64, the folder with Godot)."""
    folder = make_folder("arm64", " ".join(GODOT), fill_godot)
    emulator = make_folder("qemu", " ".join(QEMU), fill_qemu)
    names = [emulator / "usr/bin" / name for name in NAMES if (emulator / "usr/bin" / name).exists()]
    if not names:
        raise Missing(f"Debian's {QEMU[0]} has changed: it holds no {NAMES[0]}.\n{REMEDY}")
    return [str(names[0]), "-L", str(folder), *unpacked.loader_words(folder)], folder


def fill_godot(folder):
    debian.unpack("Godot for arm64", GODOT, folder, REMEDY, architecture="arm64")
    if not (folder / "lib").exists():
        (folder / "lib").symlink_to("usr/lib")
    unpacked.shed_weight(folder)


def fill_qemu(folder):
    debian.unpack("qemu", QEMU, folder, REMEDY, suite=debian.OWN)
    for other in (folder / "usr/bin").glob("qemu-*"):
        if other.name not in NAMES:
            other.unlink()
    shutil.rmtree(folder / "usr/share", ignore_errors=True)
