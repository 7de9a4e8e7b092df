"""The engine's API as the engine itself dumps it, and the binding generated from it."""

import hashlib
import os
import shutil
import subprocess
import sys
from pathlib import Path

API = "extension_api.json"
INTERFACE = "gdextension_interface.h"


class BindingError(Exception):
    """The binding could not be generated. The text has the reason and the remedy."""


def find_godot(root):
    """The Godot that dumps the API: GODOT, `godot` on PATH, or the private one; None where there is none."""
    private = Path(root) / ".toolchain/bin/godot"
    named = os.environ.get("GODOT")
    return shutil.which(named) if named else shutil.which("godot") or (str(private) if private.exists() else None)


def dump_api(godot, folder):
    """Writes the API and the interface header of `godot` into `folder`, once for each Godot."""
    stat = os.stat(os.path.realpath(godot))
    identity = f"{os.path.realpath(godot)} {stat.st_mtime_ns} {stat.st_size}"
    stamp = folder / "godot.txt"
    if stamp.exists() and stamp.read_text() == identity:
        return
    folder.mkdir(parents=True, exist_ok=True)
    words = [godot, "--headless", "--dump-extension-api", "--dump-gdextension-interface"]
    result = subprocess.run(words, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                            stdin=subprocess.DEVNULL, text=True, timeout=120)
    if not (folder / API).exists() or not (folder / INTERFACE).exists():
        raise BindingError(f"{godot} did not dump its API (exit status {result.returncode}):\n{result.stdout}")
    stamp.write_text(identity)


def digest(paths):
    total = hashlib.sha256()
    for path in paths:
        total.update(str(path).encode() + b"\0" + path.read_bytes())
    return total.hexdigest()


def generate(root, godot):
    """Brings build/binding up to date with the generator, the class list and the engine; returns that folder.

    Only files whose text changed are written, so a regeneration recompiles only what depends on them.
    """
    root = Path(root)
    api = root / "build/api"
    source = root / "extension/binding"
    folder = root / "build/binding"
    dump_api(godot, api)
    read = [path for path in source.rglob("*") if path.suffix in (".py", ".txt", ".hpp", ".h", ".inc", ".cpp")]
    inputs = [api / API, api / INTERFACE, *sorted(read)]
    now = digest(inputs)
    stamp = root / "build/binding.txt"
    if folder.is_dir() and stamp.exists() and stamp.read_text() == now:
        return folder
    fresh = root / "build/binding.new"
    shutil.rmtree(fresh, ignore_errors=True)
    words = [sys.executable, str(source / "generate.py"), "--api", str(api / API), "--interface", str(api / INTERFACE),
             "--classes", str(source / "classes.txt"), "--out", str(fresh)]
    if subprocess.run(words).returncode != 0:
        raise BindingError("extension/binding/generate.py failed; its message stands above.")
    update_folder(fresh, folder)
    shutil.rmtree(fresh)
    stamp.write_text(now)
    return folder


def update_folder(fresh, folder):
    """Makes `folder` hold what `fresh` holds, leaving files with the same text untouched."""
    wanted = {path.relative_to(fresh) for path in fresh.rglob("*") if path.is_file()}
    for old in [path for path in folder.rglob("*") if path.is_file()]:
        if old.relative_to(folder) not in wanted:
            old.unlink()
    for name in sorted(wanted):
        text = (fresh / name).read_bytes()
        target = folder / name
        if not target.exists() or target.read_bytes() != text:
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_bytes(text)
