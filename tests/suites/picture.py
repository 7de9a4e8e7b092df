"""The demo drawn by a real renderer: its picture holds plants and sky, and its plants move. Its other scenes load."""

import re
import shutil
import struct
import zlib

from toolchain import display
from toolchain.place import Missing

from . import result
from .engine import private_home
from .result import LOGS, ROOT, Result

OUT = LOGS / "picture"
# Two pictures, 8 frames apart: the gust begins after the first.
FRAMES, EVERY = 2, 8
SCENE_FRAMES = 20
TIMEOUT = 900  # s: two cores may be busy with other suites.
SCREEN = (640, 360)
# Of the first window, whose frame is not looked at, of the still, and of the frames.
WINDOW, STILL_SIZE, FRAME_SIZE = "160x90", (240, 135), (320, 180)
# Shares of all pixels (of those in the upper third for the sky), well below what the demo shows.
MIN_GREEN, MIN_SKY, MIN_MOVED = 0.15, 0.4, 0.02
# A pixel has moved if a channel changed by more than dithering.
MOVED_BY = 12


def read_png(path):
    """(width, height, rows of bytes, bytes per pixel) of an RGB or RGBA picture with 8 bits per channel."""
    data = path.read_bytes()
    width, height, depth, colour, _, _, interlaced = struct.unpack(">IIBBBBB", data[16:29])
    if depth != 8 or colour not in (2, 6) or interlaced:
        raise ValueError(f"{path.name} is no plain RGB picture")
    pixel = 3 if colour == 2 else 4
    position, packed = 8, b""
    while position < len(data):
        length, kind = struct.unpack(">I4s", data[position:position + 8])
        packed += data[position + 8:position + 8 + length] if kind == b"IDAT" else b""
        position += 12 + length
    lines, stride = zlib.decompress(packed), width * pixel + 1
    rows, above = [], bytes(width * pixel)
    for start in range(0, stride * height, stride):
        above = unfilter(lines[start], bytearray(lines[start + 1:start + stride]), above, pixel)
        rows.append(above)
    return width, height, rows, pixel


def unfilter(kind, line, above, pixel):
    """Undoes a line's filter (PNG specification, section 9)."""
    for i in range(len(line) if kind else 0):
        left = line[i - pixel] if i >= pixel else 0
        up, corner = above[i], above[i - pixel] if i >= pixel else 0
        guess = (left, up, (left + up) // 2, 0)[kind - 1]
        if kind == 4:
            near = left + up - corner
            guess = min((abs(near - left), 0, left), (abs(near - up), 1, up), (abs(near - corner), 2, corner))[2]
        line[i] = (line[i] + guess) & 255
    return bytes(line)


def pixels(rows, size):
    """All (red, green, blue) of some rows."""
    for row in rows:
        yield from zip(row[0::size], row[1::size], row[2::size])


def share(values):
    values = list(values)
    return sum(values) / len(values)


def is_green(colour):
    red, green, blue = colour
    return green > 40 and green > red and green > 1.3 * blue  # In low sun, leaves are nearly yellow.


def is_sky(colour):
    red, green, blue = colour
    return blue > 100 and blue >= green >= red - 8


def complaints(first, last):
    """Returns the errors of the first and last frame, as returned by read_png."""
    width, height, rows, size = first
    green = share(map(is_green, pixels(rows, size)))
    sky = share(map(is_sky, pixels(rows[:height // 3], size)))
    moved = share(max(map(lambda a, b: abs(a - b), one, other)) > MOVED_BY
                  for one, other in zip(pixels(rows, size), pixels(last[2], last[3])))
    found = [("green plants", green, MIN_GREEN), ("sky in its upper third", sky, MIN_SKY),
             ("moved between two frames", moved, MIN_MOVED)]
    return [f"{100 * value:.1f} % of the picture is {what}, less than {100 * minimum:.0f} %"
            for what, value, minimum in found if value < minimum]


def scene_complaints(godot):
    """Returns the errors of the demo's scenes, each run for some frames without a picture."""
    scenes = re.findall(r'"res://(\w+/\w+\.tscn)"', (ROOT / "demo_project/ui/scene_bar.gd").read_text())
    wrong = [] if len(scenes) > 1 else ["scene_bar.gd names no scenes"]
    for scene in scenes:
        words = [godot, "--headless", "--path", ROOT / "demo_project", "--fixed-fps", "15", "--quit-after", SCENE_FRAMES,
                 "res://" + scene]
        output, problem = result.run("picture:scene", words, timeout=TIMEOUT, environment=private_home())
        errors = re.findall(r"^(?:SCRIPT )?ERROR: .*", output, re.MULTILINE)
        wrong += [f"{scene}: {what}" for what in ([problem] if problem else []) + errors[:1]]
    return wrong


def demo(godot):
    """Draws the demo scene off screen and looks at its frames; runs all scenes. Five tests: all scenes run without
    errors, it draws, it shows a meadow, sizes hold."""
    shutil.rmtree(OUT, ignore_errors=True)
    prepared = result.run("picture:import", [godot, "--headless", "--path", ROOT / "demo_project", "--import"],
                          timeout=TIMEOUT, environment=private_home())[1]
    if prepared:
        return Result("picture", 0, [f"the demo project could not be imported: {prepared}"])
    words = [godot, "--path", ROOT / "demo_project", "--rendering-method", "gl_compatibility", "--fixed-fps", "15",
             "--audio-driver", "Dummy", "--resolution", WINDOW, "--script", "res://capture.gd", "--", f"--out={OUT}", f"--frames={FRAMES}",
             f"--every={EVERY}", "--size={}x{}".format(*STILL_SIZE), "--frame_size={}x{}".format(*FRAME_SIZE), "--fine=no"]
    try:
        with display.virtual(*SCREEN) as environment:
            problem = result.run("picture", words, timeout=TIMEOUT, environment=private_home(environment))[1]
        frames = sorted(OUT.glob("frames/*.png"))
        if problem or len(frames) != FRAMES:
            return Result("picture", 0, [problem or f"{len(frames)} of {FRAMES} frames were drawn"])
        return judge(OUT / "demo.png", frames, scene_complaints(godot))
    except (Missing, OSError, ValueError) as error:
        return Result("picture", 0, [str(error).replace("\n", " ")])


def judge(still, frames, of_scenes):
    sizes = {"demo.png": (read_size(still), STILL_SIZE), "a frame": (read_size(frames[0]), FRAME_SIZE)}
    failures = [f"{what} has {size[0]} × {size[1]} pixels" for what, (size, wanted) in sizes.items() if size != wanted][:1]
    wrong = complaints(read_png(frames[0]), read_png(frames[-1]))
    passed = 4 - len(failures) - len(wrong) + (not of_scenes)
    return Result("picture", passed, failures + wrong + of_scenes)


def read_size(path):
    return struct.unpack(">II", path.read_bytes()[16:24])
