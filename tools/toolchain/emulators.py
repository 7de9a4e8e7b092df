"""qemu for programs of Linux on other processors, from Debian's packages, in .toolchain/emulators: the kind that loads plugins."""

import re
import shutil
import subprocess
from dataclasses import dataclass

from . import debian
from .place import Missing, environment_with, make_folder

PACKAGES = ["qemu-user"]
LIBRARY = ["libc6"]
# {processor as in libraries' names: (qemu's name, Debian's name)}
NAMES = {"x86_64": ("qemu-x86_64", "amd64"), "arm64": ("qemu-aarch64", "arm64")}
REMEDY = "The count of instructions needs Debian on x86_64."
VERSION = re.compile(r"version (\d+)\.")


@dataclass
class Emulator:
    words: list  # That start a program.
    environment: dict
    version: int  # The first number of qemu's.


def fetch(processor):
    """The Emulator for programs of Linux on `processor`; x86_64 with all extensions that qemu has."""
    name, architecture = NAMES[processor]
    folder = make_folder("emulators", " ".join(PACKAGES), lambda place: fill(place, "qemu", PACKAGES, None))
    root = make_folder(f"libc_{architecture}", " ".join(LIBRARY),
                       lambda place: fill(place, f"the C library for {architecture}", LIBRARY, architecture))
    program = folder / "usr/bin" / name
    libraries = [folder / "usr/lib/x86_64-linux-gnu", folder / "lib/x86_64-linux-gnu"]
    environment = environment_with(LD_LIBRARY_PATH=libraries)
    answer = subprocess.run([program, "--version"], env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    found = VERSION.search(answer.stdout)
    if not found:
        raise Missing(f"Debian's {name} does not start:\n{answer.stdout}\n{REMEDY}")
    extensions = ["-cpu", "max"] if processor == "x86_64" else []
    # The program itself searches its own libraries only.
    return Emulator([str(program), "-E", "LD_LIBRARY_PATH=", *extensions, "-L", str(root)], environment, int(found.group(1)))


def fill(folder, what, packages, architecture):
    debian.unpack(what, packages, folder, REMEDY, suite=debian.OWN, architecture=architecture)
    for name in ("share", "sbin"):
        shutil.rmtree(folder / "usr" / name, ignore_errors=True)
    if (folder / "usr/lib").is_dir() and not (folder / "lib").exists():
        (folder / "lib").symlink_to("usr/lib")
