#!/usr/bin/env python3
"""Shows the demo: in a window, or off screen as build/demo.png and the animation build/demo.webp.

Off screen the demo project is called with `-- --capture=FOLDER`; it leaves its frames there as PNG files of 1280×720,
in the order of their names, FRAMES_PER_SECOND of them for each second of motion, and quits.
"""

import argparse
import shutil
import subprocess
import sys
from pathlib import Path

from toolchain import display
from toolchain.place import Missing

ROOT = Path(__file__).resolve().parents[1]
PROJECT = ROOT / "demo_project"
FRAMES = ROOT / "build/demo_frames"
WIDTH, HEIGHT = 1280, 720
FRAMES_PER_SECOND = 20
ANIMATION_SIZE = (640, 360)
IMPORT_TIMEOUT = 120
DRAWING_TIMEOUT = 300


def import_resources(godot):
    """Lets the engine prepare pictures and scripts once; a running project does not do that itself."""
    words = [godot, "--headless", "--path", str(PROJECT), "--import"]
    answer = subprocess.run(words, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                            timeout=IMPORT_TIMEOUT)
    if answer.returncode != 0:
        sys.exit(f"The engine could not import the demo project (exit status {answer.returncode}):\n{answer.stdout}")


def draw(godot):
    """The frames that the demo draws off screen."""
    shutil.rmtree(FRAMES, ignore_errors=True)
    FRAMES.mkdir(parents=True)
    words = [godot, "--path", str(PROJECT), "--rendering-method", "gl_compatibility", "--audio-driver", "Dummy",
             "--resolution", f"{WIDTH}x{HEIGHT}", "--position", "0,0", "--", f"--capture={FRAMES}"]
    with display.virtual(WIDTH, HEIGHT) as environment:
        try:
            status = subprocess.run(words, env=environment, stdin=subprocess.DEVNULL, timeout=DRAWING_TIMEOUT).returncode
        except subprocess.TimeoutExpired:
            sys.exit(f"The demo was not done after {DRAWING_TIMEOUT} s.")
    frames = sorted(FRAMES.glob("*.png"))
    if status != 0 or not frames:
        sys.exit(f"The demo drew {len(frames)} frames and ended with status {status}.")
    return frames


def write_pictures(frames):
    """The frame in the middle as build/demo.png, all of them as build/demo.webp."""
    shutil.copyfile(frames[len(frames) // 2], ROOT / "build/demo.png")
    print("build/demo.png")
    try:
        from PIL import Image
    except ImportError:
        print("No animation without Pillow: pip install pillow, or ./run demo")
        return
    pictures = [Image.open(frame).convert("RGB").resize(ANIMATION_SIZE, Image.Resampling.LANCZOS) for frame in frames]
    pictures[0].save(ROOT / "build/demo.webp", save_all=True, append_images=pictures[1:], loop=0, quality=75, method=4,
                     duration=round(1000 / FRAMES_PER_SECOND))
    print(f"build/demo.webp: {len(frames)} frames, {(ROOT / 'build/demo.webp').stat().st_size / 1e6:.1f} MB")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--godot", required=True)
    parser.add_argument("--offscreen", action="store_true")
    options = parser.parse_args()
    import_resources(options.godot)
    if not options.offscreen and display.has_display():
        return subprocess.run([options.godot, "--path", str(PROJECT)]).returncode
    try:
        write_pictures(draw(options.godot))
    except Missing as missing:
        sys.exit(str(missing))
    return 0


if __name__ == "__main__":
    sys.exit(main())
