#!/usr/bin/env python3
"""Draws the pictures of the store's page into docs/store, off screen: views of the demo, the panel, the species, and a
thumbnail; and README's stills into docs/stills. `--drawn=yes` takes the pictures that the last run has drawn."""

import argparse
import sys
from pathlib import Path

import demo
from toolchain.place import Missing

ROOT = Path(__file__).resolve().parents[1]
STORE = ROOT / "docs/store"
SIZE = (1280, 720)
THUMBNAIL = 512
STILLS = ROOT / "docs/stills"
STILL_SIZE = (640, 360)
# Views of the demo's scene.
VIEWS = {"eye_height": "meadow", "against_the_sun": "sun", "at_the_pond": "pond", "flower": "flower"}
THUMBNAIL_VIEW = "against_the_sun"
# Pictures that README shows.
SHIPPED = {"dock": "panel", "species": "species"}
QUALITY = 82
# Stills from other scenes. The scene of ivy has three cells beside each other, with titles at their lower ends.
IVY_SIZE = (2048, 440)
IVY_CELL = (0, 22, 680, 404)
OTHER_STILLS = ("ivy", "own_species")
OWN_SPECIES = "res://script_species/script_species.tscn"


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


def draw(godot):
    demo.import_resources(godot)
    demo.capture(godot, SIZE, "--frames=0", "--views=yes")
    demo.capture(godot, IVY_SIZE, "--scene=res://guide/climbers.tscn", "--name=ivy", "--frames=0")
    demo.capture(godot, STILL_SIZE, f"--scene={OWN_SPECIES}", "--name=own_species", "--frames=1")


def write_stills():
    """README's stills: views of the demo, ivy, and species of one's own."""
    from PIL import Image
    drawn = {name: Image.open(demo.OUT / f"views/{view}.png") for view, name in VIEWS.items()}
    drawn["ivy"] = Image.open(demo.OUT / "ivy.png").crop(IVY_CELL)
    drawn["own_species"] = Image.open(demo.OUT / "frames/000.png")
    STILLS.mkdir(exist_ok=True)
    for name, picture in drawn.items():
        target = STILLS / f"{name}.webp"
        picture.convert("RGB").resize(STILL_SIZE, Image.LANCZOS).save(target, quality=QUALITY, method=6)
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
            draw(options.godot)
    except Missing as missing:
        sys.exit(str(missing))
    for source, name in VIEWS.items():
        write(fitted(Image.open(demo.OUT / f"views/{source}.png")), name)
    for source, name in SHIPPED.items():
        write(fitted(Image.open(ROOT / f"docs/{source}.webp")), name)
    write_stills()
    write(square(Image.open(demo.OUT / f"views/{THUMBNAIL_VIEW}.png")), "thumbnail")
    return 0


if __name__ == "__main__":
    sys.exit(main())
