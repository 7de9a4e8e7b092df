"""What a Godot project needs to find the add-on: a link to it, and its name in the list of extensions."""

import os
import shutil
import subprocess
from pathlib import Path

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


def prepare(project, addons):
    """Everything for the project folder `project` and the folder `addons`."""
    if Path(project).is_dir():
        link(addons, Path(project) / "addons")
        list_extensions(project)
