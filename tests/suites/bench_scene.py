"""The bench scene at its smallest size: it writes every figure, logs no error, and its picture is of plants."""

import argparse

from bench_scene import measure
from toolchain.place import Missing

from . import picture
from .result import LOGS, Result

# Pixels and frames for a software renderer.
SIZE, FRAMES, PLANTS = "160x90", 3, 400
MIN_GREEN = 0.15
FOLDER = LOGS / "bench_scene"


def run(godot):
    """Three tests: all figures are numbers, no error was logged, the picture shows plants."""
    options = argparse.Namespace(godot=godot, plants=PLANTS, frames=FRAMES, size=SIZE, method="forward_plus", other="")
    FOLDER.mkdir(parents=True, exist_ok=True)
    out, drawn = FOLDER / "report.json", FOLDER / "report.png"
    try:
        report = measure.measure(options, FOLDER / "project", out, drawn)
    except (Missing, SystemExit) as problem:
        return Result("bench_scene", 0, [str(problem).replace("\n", " ")])
    failures = [f"{name} is missing" for name in measure.missing_figures(report)] + report["first_errors"]
    figures = report["figures"]
    if not failures and not 0 < figures["draw_calls"] <= figures["max_draw_calls"]:
        failures.append(f"{figures['draw_calls']} draw calls of at most {figures['max_draw_calls']}")
    if not failures and not figures["primitives"] > PLANTS:
        failures.append(f"{figures['primitives']} primitives of {PLANTS} plants")
    _, _, rows, size = picture.read_png(drawn)
    green = picture.share(map(picture.is_green, picture.pixels(rows, size)))
    failures += [f"{100 * green:.1f} % of the picture is green"] if green < MIN_GREEN else []
    return Result("bench_scene", 3 - min(len(failures), 3), failures)
