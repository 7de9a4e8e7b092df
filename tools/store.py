#!/usr/bin/env python3
"""Draws the pictures of the store's page into docs/store, off screen: views of the demo, the panel, the species, and a
thumbnail. `--drawn=yes` takes the views that the last run has drawn."""

import argparse
import sys
from pathlib import Path

import demo
from toolchain.place import Missing

ROOT = Path(__file__).resolve().parents[1]
STORE = ROOT / "docs/store"
SIZE = (1280, 720)
THUMBNAIL = 512
# Views of the demo's scene.
VIEWS = {"eye_height": "meadow", "against_the_sun": "sun", "at_the_pond": "pond", "flower": "flower"}
THUMBNAIL_VIEW = "against_the_sun"
# Pictures that README shows.
SHIPPED = {"dock": "panel", "species": "species"}
QUALITY = 82


def fitted(picture):
    """The picture within SIZE, on a dark ground where its shape is another."""
    from PIL import Image
    picture = picture.convert("RGB")
    picture.thumbnail(SIZE, Image.LANCZOS)
    ground = Image.new("RGB", SIZE, (29, 34, 41))
    ground.paste(picture, ((SIZE[0] - picture.width) // 2, (SIZE[1] - picture.height) // 2))
    return ground


def square(picture):
    """The right part of the picture as a square of THUMBNAIL pixels."""
    from PIL import Image
    side = min(picture.size)
    left, top = picture.width - side, (picture.height - side) // 2
    return picture.convert("RGB").crop((left, top, left + side, top + side)).resize((THUMBNAIL, THUMBNAIL), Image.LANCZOS)


def write(picture, name):
    target = STORE / f"{name}.jpg"
    picture.save(target, quality=QUALITY, optimize=True, progressive=True)
    print(f"{target.relative_to(ROOT)}: {target.stat().st_size / 1e3:.0f} kB")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--godot", required=True)
    parser.add_argument("--drawn", default="no", choices=["yes", "no"])
    options = parser.parse_args()
    try:
        from PIL import Image
    except ImportError:
        sys.exit("The store's pictures need Pillow: pip install pillow, or ./run store")
    STORE.mkdir(exist_ok=True)
    try:
        if options.drawn == "no":
            demo.import_resources(options.godot)
            demo.capture(options.godot, SIZE, "--frames=0", "--views=yes")
    except Missing as missing:
        sys.exit(str(missing))
    for source, name in VIEWS.items():
        write(fitted(Image.open(demo.OUT / f"views/{source}.png")), name)
    for source, name in SHIPPED.items():
        write(fitted(Image.open(ROOT / f"docs/{source}.webp")), name)
    write(square(Image.open(demo.OUT / f"views/{THUMBNAIL_VIEW}.png")), "thumbnail")
    return 0


if __name__ == "__main__":
    sys.exit(main())
