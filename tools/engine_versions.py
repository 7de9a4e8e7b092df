#!/usr/bin/env python3
"""Compares the engine methods that the library calls with the API dumps of several Godot versions.

The library looks each method up by name and signature hash. A version can load the library if it has every method with
that hash, or lists the hash as compatible. The dumps are in the crate gdextension-api, which cargo fetches; --dumps names
a folder with VERSION/extension_api.json instead."""

import argparse
import json
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
CRATE = "gdextension-api"
CRATE_VERSION = "0.5.1"
VERSIONS = ["4.5", "4.6", "4.7"]
BUILT_FOR = "4.6"  # The oldest version that the library loads in.
CALL = re.compile(r" U godot::(\w+)::(\w+)\(")
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


def calls_of(text):
    """Class and method of each engine call in the output of `nm -C --undefined-only`."""
    return set(CALL.findall(text))


def read(folder, version):
    path = folder / version / "extension_api.json"
    return {entry["name"]: entry for entry in json.loads(path.read_text(encoding="utf-8"))["classes"]}


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
    own = read(dumps, BUILT_FOR)
    used = sum(1 for call in calls if "hash" in (find_method(own, *call) or {}))
    fails = False
    for version in VERSIONS:
        missing, changed = compare(calls, own, read(dumps, version))
        print(f"Godot {version}: {used} methods, {len(missing)} missing, {len(changed)} with another signature")
        print("".join(f"  missing: {one}\n" for one in missing) + "".join(f"  changed: {one}\n" for one in changed), end="")
        fails = fails or (float(version) >= float(BUILT_FOR) and bool(missing or changed))
    sys.exit(1 if fails else 0)


if __name__ == "__main__":
    main()
