#!/usr/bin/env python3
"""Writes build/undergrowth.zip: the folder addons/undergrowth with the libraries built so far, to unpack in a project."""

import sys
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
ADDON = ROOT / "addons/undergrowth"
# What compilers leave beside a library.
LEFT_OUT = {".exp", ".lib", ".pdb", ".ilk"}
FIXED_TIME = (2026, 1, 1, 0, 0, 0)


def is_shipped(path):
    """Not the copy `~lib…` of a library either that an open editor makes to reload it."""
    return path.is_file() and path.suffix not in LEFT_OUT and not path.name.startswith("~")


def main():
    paths = [path for path in sorted(ADDON.rglob("*")) if is_shipped(path)]
    target = ROOT / "build/undergrowth.zip"
    with zipfile.ZipFile(target, "w", zipfile.ZIP_DEFLATED) as archive:
        for path in paths:
            # A fixed time: the same files give the same archive.
            entry = zipfile.ZipInfo(path.relative_to(ROOT).as_posix(), FIXED_TIME)
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = (0o755 if path.suffix in (".so", ".dylib") else 0o644) << 16
            archive.writestr(entry, path.read_bytes())
    print("\n".join(f"with {path.name}" for path in paths if path.parent.name == "bin"))
    if not any("template_release" in path.name for path in paths):
        print("without a library for exported games: `./run build target=template_release` first makes one")
    print(f"{target.relative_to(ROOT)}: {len(paths)} files, {target.stat().st_size / 1e6:.1f} MB")
    return 0


if __name__ == "__main__":
    sys.exit(main())
