"""What a Godot project needs to find the add-on: a link to it, its name in the list of extensions, and the uids of its
files."""

import os
import re
import shutil
import struct
import subprocess
from pathlib import Path

UID = re.compile(r'\b(uid://[a-y0-8]+)')
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


<<<<<<< HEAD
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
=======
def uid_number(text):
    """The number that `uid://` and a word of the digits a to y and 0 to 8 stand for."""
    number = 0
    for digit in text.removeprefix("uid://"):
        number = number * 34 + (ord(digit) - ord("a") if digit.isalpha() else ord(digit) - ord("0") + 25)
    return number & 0x7FFFFFFFFFFFFFFF


def list_uids(project):
    """Writes the project's list of uids if there is none, as the editor does when it opens a project.

    Without it the engine warns of each uid by which a file refers to another one.
    """
    path = Path(project) / ".godot/uid_cache.bin"
    if path.exists():
        return
    entries = b""
    count = 0
    for folder, folders, files in os.walk(project, followlinks=True):
        folders[:] = [name for name in folders if not name.startswith(".")]
        for name in files:
            file = Path(folder) / name
            if file.suffix not in (".tres", ".tscn", ".uid", ".import"):
                continue
            text = file.read_text(encoding="utf-8", errors="replace")
            found = UID.search(text.partition("\n")[0] if file.suffix in (".tres", ".tscn") else text)
            if found:
                kept = file.with_suffix("") if file.suffix in (".uid", ".import") else file
                place = ("res://" + kept.relative_to(project).as_posix()).encode()
                entries += struct.pack("<QI", uid_number(found[1]), len(place)) + place
                count += 1
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(struct.pack("<I", count) + entries)
>>>>>>> main


def prepare(project, addons):
    """Everything for the project folder `project` and the folder `addons`."""
    if Path(project).is_dir():
        link(addons, Path(project) / "addons")
        list_extensions(project)
<<<<<<< HEAD
        list_uids(project, addons)
=======
        list_uids(project)
>>>>>>> main
