#!/usr/bin/env python3
"""Compares the engine methods that the library calls, and the names in the add-on's scripts and scenes, with the API dumps
of several Godot versions.

The library looks each method up by name and signature hash. A version can load the library if it has every method with
that hash, or lists the hash as compatible. Scripts for newer versions only (NEWER_ONLY) are left out. The dumps are in the
crate gdextension-api, which cargo fetches; --dumps names a folder with VERSION/extension_api.json instead."""

import argparse
import json
import re
import subprocess
import sys
from pathlib import Path

import script_names

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "extension/binding"))

from generator import interface  # noqa: E402  (the path above comes first)

CRATE = "gdextension-api"
CRATE_VERSION = "0.5.1"
VERSIONS = ["4.5", "4.6", "4.7"]
BUILT_FOR = "4.6"  # The version whose API the library is built with.
ADD_ON = ROOT / "addons/undergrowth"
SCRIPTS, SCENES = {".gd"}, {".tscn", ".tres"}
# Loaded only where the engine has the class EditorDock, since 4.6.
NEWER_ONLY = {"editor_dock.gd"}
CALL = re.compile(r" U godot::(\w+)::(\w+)\(")
OVERRIDE = re.compile(r"\b(_\w+)\([^;{]*\boverride\b")
MANIFEST = f"""[package]
name = "dumps"
version = "0.0.0"
edition = "2021"

[lib]
path = "lib.rs"

[dependencies]
{CRATE} = "={CRATE_VERSION}"
"""


def find_method(classes, name, method):
    """The method's entry in the dump, of the class or its nearest base class that has it."""
    while name in classes:
        for entry in classes[name].get("methods", []):
            if entry["name"] == method:
                return entry
        name = classes[name].get("inherits")
    return None


def compare(calls, own, other):
    """The calls that `other` lacks, and those whose hash in `own` it does not know. Both are dumps: classes by name."""
    missing, changed = [], []
    for name, method in sorted(calls):
        wanted = find_method(own, name, method)
        if wanted is None or "hash" not in wanted:  # Not a method of the engine: built-in types, the binding's own.
            continue
        found = find_method(other, name, method)
        if found is None:
            missing.append(f"{name}.{method}")
        elif wanted["hash"] not in [found["hash"], *found.get("hash_compatibility", [])]:
            changed.append(f"{name}.{method}")
    return missing, changed


def script_faults(own, other, folder=ADD_ON):
    """{file: names that `other` lacks} of the add-on's scripts and scenes. Both are names of dumps."""
    texts = {path: path.read_text(encoding="utf-8") for path in sorted(folder.rglob("*"))
             if path.suffix in SCRIPTS | SCENES and path.name not in NEWER_ONLY}
    declared = {name for path, text in texts.items() if path.suffix in SCRIPTS for name in script_names.own_names(text)}
    faults = {}
    for path, text in texts.items():
        is_script = path.suffix in SCRIPTS
        used = script_names.used_in_script(text, declared) if is_script else script_names.used_in_scene(text)
        lost = script_names.lacking(used, own, other)
        faults.update({path.relative_to(folder).as_posix(): lost} if lost else {})
    return faults


def overridden(folder):
    """The names of the engine's virtual methods that the library's classes override."""
    return {name for path in folder.rglob("*.hpp") for name in OVERRIDE.findall(path.read_text(encoding="utf-8"))}


def virtual_calls(names, classes):
    """Class and method of each virtual method of the engine with one of these names."""
    return {(name, method["name"]) for name, entry in classes.items() for method in entry.get("methods", [])
            if method.get("is_virtual") and method["name"] in names}


def newer_functions(table, used, version):
    """The used functions of the extension interface that are newer than the version. `table` is that of the crate."""
    def number(text):
        return tuple(map(int, text.split(".")))
    return sorted(one["name"] for one in table if one["name"] in used and number(one["since"]) > number(version))


def calls_of(text):
    """Class and method of each engine call in the output of `nm -C --undefined-only`."""
    return set(CALL.findall(text))


def read(folder, version):
    """A dump: its classes by name, and its names for scripts."""
    dump = json.loads((folder / version / "extension_api.json").read_text(encoding="utf-8"))
    return {entry["name"]: entry for entry in dump["classes"] + dump["builtin_classes"]}, script_names.Names(dump)


def fetch(folder):
    """Fetches the crate; returns its folder of dumps."""
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "Cargo.toml").write_text(MANIFEST, encoding="utf-8")
    (folder / "lib.rs").touch()
    words = ["cargo", "metadata", "--format-version=1", f"--manifest-path={folder / 'Cargo.toml'}"]
    try:
        done = subprocess.run(words, capture_output=True, text=True, check=True)
    except FileNotFoundError:
        sys.exit("cargo is missing: install it, or pass --dumps=FOLDER with VERSION/extension_api.json.")
    except subprocess.CalledProcessError as problem:
        sys.exit(f"cargo cannot fetch {CRATE} {CRATE_VERSION}:\n{problem.stderr}")
    packages = json.loads(done.stdout)["packages"]
    return Path(next(one for one in packages if one["name"] == CRATE)["manifest_path"]).parent / "src"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--objects", required=True, help="folder of the library's object files")
    parser.add_argument("--dumps", help="folder with VERSION/extension_api.json")
    options = parser.parse_args()
    objects = sorted(Path(options.objects).rglob("*.os"))
    if not objects:
        sys.exit(f"{options.objects} has no object files: run ./run build.")
    words = ["nm", "-C", "--undefined-only", *map(str, objects)]
    calls = calls_of(subprocess.run(words, capture_output=True, text=True, check=True).stdout)
    dumps = Path(options.dumps) if options.dumps else fetch(ROOT / "build/engine_versions")
    own, own_names = read(dumps, BUILT_FOR)
    calls |= virtual_calls(overridden(ROOT / "extension/godot"), own)
    used = sum(1 for call in calls if "hash" in (find_method(own, *call) or {}))
    binding = ROOT / "extension/binding"
    functions = interface.used_names([path.read_text(encoding="utf-8") for path in binding.rglob("*.[ch]pp")])
    table = json.loads((dumps / "gdextension_interface.json").read_text(encoding="utf-8"))["interface"]
    fails = False
    for version in VERSIONS:
        other, names = read(dumps, version)
        missing, changed = compare(calls, own, other)
        missing += newer_functions(table, functions, version)
        faults = script_faults(own_names, names)
        print(f"Godot {version}: {used} methods, {len(functions)} functions, {len(missing)} missing, {len(changed)} with another signature; "
              f"{len(faults)} scripts with missing names")
        lines = [f"missing: {one}" for one in missing] + [f"changed: {one}" for one in changed]
        lines += [f"{file}: {', '.join(lost)}" for file, lost in faults.items()]
        print("".join(f"  {line}\n" for line in lines), end="")
        fails = fails or bool(lines)
    sys.exit(1 if fails else 0)


if __name__ == "__main__":
    main()
