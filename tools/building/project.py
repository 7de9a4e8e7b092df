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


def prepare(project, addons):
    """Everything for the project folder `project` and the folder `addons`."""
    if Path(project).is_dir():
        link(addons, Path(project) / "addons")
        list_extensions(project)
        list_uids(project)
