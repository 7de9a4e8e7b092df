#!/usr/bin/env python3
"""Writes the generated part of the binding from the dumps of the engine.

    generate.py --api extension_api.json --interface gdextension_interface.h --classes classes.txt --out DIR
    generate.py ... --list          lists the outputs (relative to DIR), writes nothing

The inputs come from `godot --headless --dump-extension-api --dump-gdextension-interface`. Files with
unchanged text are not written, so that a build by modification times does not compile them again.
"""

import argparse
import json
import sys
from pathlib import Path

from generator import builtins, classes, interface, types

sys.dont_write_bytecode = True
LINES_OF_A_SOURCE = 1500
SOURCES = (".cpp", ".hpp", ".inc")


def generate(api, interface_text, listed, folder):
    """Returns all generated files as {path relative to the output folder: text}; `folder` has the manual part."""
    names = types.Names(api, listed)
    headers = folder / "include" / "godot_cpp"
    files = {**builtins.files(api, names, headers), **classes.files(api, names, headers)}
    written = [path.read_text(encoding="utf-8") for path in sorted(folder.rglob("*")) if path.suffix in SOURCES]
    files.update(interface.files(interface_text, interface.used_names([*written, *files.values()])))
    files["include/gdextension_interface.h"] = interface_text
    return join_sources(files)


def join_sources(files):
    """Joins the sources into fewer and longer ones: headers, which all share, take most of the compile time."""
    joined = {name: text for name, text in files.items() if not name.endswith(".cpp")}
    number, length = 0, 0
    for name in sorted(name for name in files if name.endswith(".cpp")):
        part = f"src/part_{number}.cpp"
        joined[part] = joined.get(part, "") + files[name]
        length += files[name].count("\n")
        if length > LINES_OF_A_SOURCE:
            number, length = number + 1, 0
    return joined


def read_class_list(path):
    lines = (line.split("#")[0].strip() for line in Path(path).read_text().splitlines())
    return [line for line in lines if line]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    for name in ("api", "interface", "classes", "out"):
        parser.add_argument("--" + name, required=True)
    parser.add_argument("--list", action="store_true")
    options = parser.parse_args()
    files = generate(
        json.loads(Path(options.api).read_text(encoding="utf-8")),
        Path(options.interface).read_text(encoding="utf-8"),
        read_class_list(options.classes),
        Path(__file__).resolve().parent,
    )
    for name, text in sorted(files.items()):
        if options.list:
            print(name)
            continue
        path = Path(options.out) / name
        path.parent.mkdir(parents=True, exist_ok=True)
        if not path.exists() or path.read_text(encoding="utf-8") != text:
            path.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
