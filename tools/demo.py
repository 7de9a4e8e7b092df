#!/usr/bin/env python3
"""Shows the demo: in a window, or off screen as build/demo.png, stills from six more places in build/views, the animation
build/demo.webp, and build/species.png with all ready species."""

import argparse
import functools
import shutil
import subprocess
import sys
from pathlib import Path

from toolchain import display
from toolchain.place import Missing

ROOT = Path(__file__).resolve().parents[1]
PROJECT = ROOT / "demo_project"
OUT = ROOT / "build/demo"
FRAMES = 60
SHEET_SIZE = (1680, 1900)
FRAMES_PER_SECOND = 15
IMPORT_TIMEOUT = 120
DRAWING_TIMEOUT = 1800  # s: a software renderer on a busy machine needs more than 600.


def import_resources(godot):
    """Lets the engine prepare pictures and scripts once; a running project does not do that itself."""
    words = [godot, "--headless", "--path", str(PROJECT), "--import"]
    run = functools.partial(subprocess.run, words, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                            stderr=subprocess.STDOUT, text=True, timeout=IMPORT_TIMEOUT)
    try:
        answer = run()
    except subprocess.TimeoutExpired:  # The engine may hang at its exit while its threads still start.
        print(f"The engine did not end {IMPORT_TIMEOUT} s after it began to import; once more.")
        answer = run()
    if answer.returncode != 0:
        sys.exit(f"The engine could not import the demo project (exit status {answer.returncode}):\n{answer.stdout}")


def capture(godot, size, *options):
    """Has the demo project's capture.gd draw off screen into OUT."""
    words = [godot, "--path", str(PROJECT), "--rendering-method", "forward_plus", "--fixed-fps", str(FRAMES_PER_SECOND),
             "--audio-driver", "Dummy", "--script", "res://capture.gd", "--", f"--out={OUT}",
             "--size={}x{}".format(*size), *options]
    with display.virtual(*size) as environment:
        try:
            status = subprocess.run(words, env=environment, stdin=subprocess.DEVNULL, timeout=DRAWING_TIMEOUT).returncode
        except subprocess.TimeoutExpired:
            sys.exit(f"The demo was not drawn after {DRAWING_TIMEOUT} s.")
    if status != 0:
        sys.exit(f"The demo's drawing ended with status {status}.")


def draw(godot):
    """The demo's still picture and its frames, and the sheet of all species."""
    shutil.rmtree(OUT, ignore_errors=True)
    capture(godot, (1280, 720), f"--frames={FRAMES}", "--views=yes")
    capture(godot, SHEET_SIZE, "--scene=res://species/species_sheet.tscn", "--name=species", "--frames=0")
    still, sheet, frames = OUT / "demo.png", OUT / "species.png", sorted(OUT.glob("frames/*.png"))
    if not still.exists() or not sheet.exists() or len(frames) != FRAMES:
        sys.exit(f"The demo drew {len(frames)} of {FRAMES} frames.")
    return still, sheet, frames


def write_pictures(still, sheet, frames):
    """build/demo.png, build/species.png and, where Pillow is, build/demo.webp."""
    for picture in (still, sheet):
        shutil.copyfile(picture, ROOT / "build" / picture.name)
        print(f"build/{picture.name}")
    views = ROOT / "build/views"
    shutil.rmtree(views, ignore_errors=True)
    shutil.copytree(OUT / "views", views)
    print(f"build/views: {len(list(views.iterdir()))} stills")
    try:
        from PIL import Image
    except ImportError:
        print("No animation without Pillow: pip install pillow, or ./run demo")
        return
    target = ROOT / "build/demo.webp"
    pictures = [Image.open(frame).convert("RGB") for frame in frames]
    pictures[0].save(target, save_all=True, append_images=pictures[1:], loop=0, quality=75, method=4,
                     duration=round(1000 / FRAMES_PER_SECOND))
    print(f"build/demo.webp: {len(frames)} frames, {target.stat().st_size / 1e6:.1f} MB")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--godot", required=True)
    parser.add_argument("--offscreen", action="store_true")
    options = parser.parse_args()
    import_resources(options.godot)
    if not options.offscreen and display.has_display():
        return subprocess.run([options.godot, "--path", str(PROJECT)]).returncode
    try:
        write_pictures(*draw(options.godot))
    except Missing as missing:
        sys.exit(str(missing))
    return 0


if __name__ == "__main__":
    sys.exit(main())
