#!/usr/bin/env python3
"""Draws the pictures of docs/guide off screen, from the scenes of demo_project/guide; `--only=wind` draws one."""

import argparse
import sys
from pathlib import Path

import demo
from toolchain.place import Missing

ROOT = Path(__file__).resolve().parents[1]
SCENES = ROOT / "demo_project/guide"
PICTURES = ROOT / "docs/guide/pictures"
SIZE = (1080, 360)
QUALITY = 80


def draw(godot, name):
    """One scene as PNG below build/demo; where it is."""
    demo.capture(godot, SIZE, f"--scene=res://guide/{name}.tscn", f"--name=guide_{name}", "--frames=0")
    return demo.OUT / f"guide_{name}.png"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--godot", required=True)
    parser.add_argument("--only", default="")
    options = parser.parse_args()
    try:
        from PIL import Image
    except ImportError:
        sys.exit("The guide's pictures need Pillow: pip install pillow, or ./run guide")
    names = [name for name in sorted(path.stem for path in SCENES.glob("*.tscn")) if options.only in ("", name)]
    if not names:
        sys.exit(f"There is no scene demo_project/guide/{options.only}.tscn.")
    demo.import_resources(options.godot)
    PICTURES.mkdir(exist_ok=True)
    try:
        for name in names:
            target = PICTURES / f"{name}.webp"
            Image.open(draw(options.godot, name)).convert("RGB").save(target, quality=QUALITY, method=6)
            print(f"{target.relative_to(ROOT)}: {target.stat().st_size / 1e3:.0f} kB")
    except Missing as missing:
        sys.exit(str(missing))
    return 0


if __name__ == "__main__":
    sys.exit(main())
