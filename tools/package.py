#!/usr/bin/env python3
"""Writes build/undergrowth-VERSION.zip: the folder addons/undergrowth with the libraries for all platforms, to unpack in
a project. What is wrong with a library is said, and no zip is left.

--here takes the libraries that lie in addons/undergrowth/bin instead, for build/undergrowth-VERSION-here.zip.
"""

import argparse
import shutil
import sys
from pathlib import Path

from building import compiler
from shipping import archive, universal
from toolchain import zig
from toolchain.place import Missing

ROOT = archive.ROOT
BUILT = "build/package/bin"
# Libraries for single processors of Macs, which are joined.
PARTS = "build/package/parts"


def build_all(program, jobs):
    """The libraries of all platforms in build/package/bin, and nothing else."""
    for folder in (BUILT, PARTS):
        shutil.rmtree(ROOT / folder, ignore_errors=True)
    for platform, arch in compiler.ZIG_TARGETS:
        print(f"{platform} {arch}", flush=True)
        into = PARTS if platform == "macos" else BUILT
        zig.build(platform, arch, "build", "target=both", f"into={into}", program=program, jobs=jobs)
    join_parts(ROOT / PARTS, ROOT / BUILT)


def join_parts(parts, libraries):
    """Writes the universal libraries of the folder `parts` into the folder `libraries`."""
    for kind in ("template_debug", "template_release"):
        names = {arch: compiler.library_name("macos", kind, arch) for arch in compiler.MAC_PROCESSORS}
        joined = universal.join({arch: (parts / name).read_bytes() for arch, name in names.items()})
        (libraries / compiler.library_name("macos", kind, "universal")).write_bytes(joined)


def pack(root, libraries, is_for_all):
    """Writes the zip; returns what is wrong with it, and then nothing is left."""
    target = archive.place(root, is_for_all)
    target.unlink(missing_ok=True)
    fresh = target.with_suffix(".new")
    found = archive.files(root, libraries)
    archive.write(fresh, found)
    wrong = archive.complaints(fresh, archive.build_paths(root), is_for_all)
    if wrong:
        fresh.unlink()
        return [line.replace(fresh.name, target.name) for line in wrong]
    fresh.replace(target)
    print("\n".join(f"with {path.name}" for name, path in found.items() if "/bin/" in name))
    if not any("template_release" in name for name in found):
        print("without a library for exported games: `./run build target=both` makes it")
    print(f"{target.relative_to(root)}: {len(found)} files, {target.stat().st_size / 1e6:.1f} MB")
    return []


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--here", action="store_true", help="only what this machine has built")
    parser.add_argument("--zig", help="the program; without it, it is fetched")
    parser.add_argument("--jobs", type=int, help="how many compilers at once")
    options = parser.parse_args()
    try:
        if not options.here:
            build_all(options.zig, options.jobs)
    except Missing as problem:
        print(problem)
        return 1
    wrong = pack(ROOT, ROOT / (f"{archive.ADDON}/bin" if options.here else BUILT), not options.here)
    for line in wrong:
        print(f"Not packed: {line}")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
