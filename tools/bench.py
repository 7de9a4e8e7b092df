#!/usr/bin/env python3
"""Measures the core and the add-on, in a headless engine and in renderers without a graphics card.

Prints a table and what it means, writes build/bench.json and build/bench.png. All measuring programs print a JSON list
of rows {"name", "plants", "threads", "median_ms", "us_per_plant"}; rows of the engine also have a "renderer".

--release measures in an exported game, with the engine's release template and the add-on's release library.

Three parts are measured only where they are named. gpu fetches packages once, and estimates the time of a graphics card
without one, from the cycles that Mesa's compiler states for the shaders (tools/gpu). card measures the time of this
machine's graphics card, in a window. instructions counts, in qemu, the instructions of the core's kernels for SSE2, AVX2
and NEON, and compares the bits that they write (tools/instructions).
"""

import argparse
import itertools
import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "tests"))

import bench_plot  # noqa: E402  (the path above comes first)
import bench_summary  # noqa: E402
from gpu import measure as gpu  # noqa: E402
from instructions import measure as instructions  # noqa: E402
from suites import engine, exporting  # noqa: E402
from toolchain import display  # noqa: E402
from toolchain.place import Missing  # noqa: E402

COLUMNS = ("name", "plants", "threads", "median_ms", "us_per_plant", "renderer")
RENDERERS = ("forward_plus", "gl_compatibility")
TIMEOUT = 600  # s
SCENE_TIMEOUT = 1800  # s: a software renderer draws a million plants.
ENGINE_SCRIPTS = {
    "plants": "engine_bench",
    "fields": "field_bench",
    "edits": "edits_bench",
    "many": "many_fields_bench",
    "ground": "ground_bench",
}
SCENE_COUNTS = (10_000, 100_000, 1_000_000)
CARD_RENDERERS = ("forward_plus", "mobile", "gl_compatibility")
DRAWN_SCRIPTS = ("engine_bench", "field_bench")
DEFAULT_PARTS = ("core", *ENGINE_SCRIPTS, "scene", "drawn")
PARTS = (*DEFAULT_PARTS, "gpu", "card", "instructions")
STEADY = ["--fixed-fps", "60", "--disable-vsync"]
# What makes a script of tests/bench the main loop of a game.
GAME = """
[application]

run/main_scene="res://empty.tscn"
run/main_loop_type="BenchMainLoop"
"""
MAIN_LOOP = 'class_name BenchMainLoop\nextends "res://tests/bench/{}.gd"\n'
# The project must select Jolt and set its maximum number of bodies.
JOLT = """
[physics]

3d/physics_engine="Jolt Physics"
jolt_physics_3d/limits/max_bodies=20000
jolt_physics_3d/limits/max_body_pairs=65536
"""


def rows_in(output):
    """The JSON list in a program's output; the engine prints a banner above it."""
    start = next((i for i, line in enumerate(output.splitlines()) if line.startswith("[")), None)
    if start is None:
        raise ValueError("no JSON list in the output")
    return json.JSONDecoder().raw_decode("\n".join(output.splitlines()[start:]))[0]


def measure(name, words, environment=None, timeout=TIMEOUT):
    """The rows that a program prints; it shows the program's words and stops where there are none."""
    answer = subprocess.run(words, stdout=subprocess.PIPE, text=True, timeout=timeout, env=environment, cwd=ROOT)
    try:
        return rows_in(answer.stdout)
    except ValueError as error:
        sys.exit(f"{name} measured nothing ({error}, exit status {answer.returncode}):\n{answer.stdout[-2000:]}")


def editor_start(godot, folder):
    """start(script): the words that run a script of tests/bench in the editor's engine."""
    return lambda script: [godot, "--path", str(folder), *STEADY, "--script", f"res://tests/bench/{script}.gd"]


def game_start(godot, folder):
    """start(script): the same in an exported game, with the script as its main loop."""
    (folder / "empty.tscn").write_text('[gd_scene format=3]\n\n[node name="Empty" type="Node"]\n')
    with open(folder / "project.godot", "a", encoding="utf-8") as settings:
        settings.write(GAME)
    (folder / "main_loop.gd").write_text(MAIN_LOOP.format("field_bench"))
    problem = exporting.prepare("bench:import", godot, folder)

    def start(script):
        game = folder.parent / "bench_games" / script / "game"
        (folder / "main_loop.gd").write_text(MAIN_LOOP.format(script))
        output, wrong = exporting.export(f"bench:{script}", godot, folder, "release", game)
        if problem or wrong:
            sys.exit(f"{script} could not be exported: {problem or wrong}\n{output[-2000:]}")
        return [str(game), *STEADY]

    return start


def drawn_rows(start, surroundings):
    """Fields, and plants of four joints, in each renderer, in a virtual display; nothing where there is none."""
    rows = []
    words = {script: start(script) for script in DRAWN_SCRIPTS}
    for method, script in itertools.product(RENDERERS, DRAWN_SCRIPTS):
        drawn = [*words[script], "--rendering-method", method, "--audio-driver", "Dummy", "--resolution", "320x180"]
        try:
            with display.virtual(640, 360) as environment:
                rows += measure(f"{script} in {method}", drawn, surroundings(environment))
        except Missing as missing:
            print(f"{script} in {method} is not measured: {missing}")
    return rows


def scene_rows(start, surroundings):
    """The rows of scene_bench.gd. Each number of plants has its own processes, since freed memory stays in a process.

    The counts are missing where there is no virtual display.
    """
    words = start("scene_bench")
    rows = []
    for count in SCENE_COUNTS:
        rows += measure("scene_bench", [*words, "--headless", "--", str(count)], surroundings(os.environ))
    drawn = [*words, "--rendering-method", "forward_plus", "--audio-driver", "Dummy", "--"]
    try:
        with display.virtual(1920, 1080) as environment:
            for count in SCENE_COUNTS:
                rows += measure("scene_bench in forward_plus", [*drawn, str(count)], surroundings(environment),
                                SCENE_TIMEOUT)
    except Missing as missing:
        print(f"scene_bench in forward_plus is not measured: {missing}")
    return rows


def card_rows(start, surroundings):
    """The times of the graphics card in all renderers; nothing where there is no display."""
    if not display.has_display():
        print("card is not measured: there is no display")
        return []
    rows = []
    words = [*start("card_bench"), "--audio-driver", "Dummy", "--resolution", "1920x1080"]
    for method, count in itertools.product(CARD_RENDERERS, (0, *SCENE_COUNTS)):
        rows += measure(f"card_bench in {method}", [*words, "--rendering-method", method, "--", str(count)],
                        surroundings(os.environ), SCENE_TIMEOUT)
    return rows


def gpu_rows(godot, folder):
    """The estimate for graphics cards; nothing where the driver cannot be had or does not start."""
    try:
        return gpu.rows(godot, folder, engine.private_home, SCENE_COUNTS)
    except Missing as missing:
        reason = str(missing).splitlines()[0].rstrip(":")
        print(f"gpu is not measured: {reason}")
        return []


def instruction_rows():
    """The instructions of the kernels; nothing where no emulator can be had."""
    try:
        return instructions.rows()
    except Missing as missing:
        print(f"instructions are not counted: {missing}")
        return []


def table(rows):
    texts = [COLUMNS] + [tuple(text(row.get(column)) for column in COLUMNS) for row in rows]
    widths = [max(len(line[i]) for line in texts) for i in range(len(COLUMNS))]
    return "\n".join("  ".join(cell.ljust(width) if i == 0 else cell.rjust(width)
                               for i, (cell, width) in enumerate(zip(line, widths))) for line in texts)


def text(value):
    return f"{value:.4g}" if isinstance(value, float) else "" if value is None else str(value)


def plot(rows):
    """build/bench.png, where matplotlib is."""
    target = ROOT / "build/bench.png"
    try:
        if bench_plot.draw(rows, target):
            print(target.relative_to(ROOT))
    except ImportError as error:
        print(f"No plot ({error}): pip install matplotlib, or ./run bench where pip reaches a package index")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--godot", required=True)
    parser.add_argument("--core", help="the program that measures the core")
    parser.add_argument("--parts", default=",".join(DEFAULT_PARTS), help="what to measure: some of " + ", ".join(PARTS))
    parser.add_argument("--release", action="store_true", help="in an exported game")
    options = parser.parse_args()
    parts = set(options.parts.split(","))
    if not parts <= set(PARTS):
        parser.error(f"no such part: {', '.join(sorted(parts - set(PARTS)))}; there are {', '.join(PARTS)}")
    rows = measure("core_bench", [options.core]) if options.core and "core" in parts else []
    rows += instruction_rows() if "instructions" in parts else []
    # An editor that exports writes beside what it finds, so it gets a copy.
    folder = engine.make_project("bench_project", {} if options.release else {"tests/bench": "tests/bench"})
    if options.release:
        shutil.copytree(ROOT / "tests/bench", folder / "tests/bench")
    with open(folder / "project.godot", "a", encoding="utf-8") as settings:
        settings.write(JOLT)
    start = (game_start if options.release else editor_start)(options.godot, folder)
    surroundings = exporting.surroundings if options.release else engine.private_home
    for script in (name for part, name in ENGINE_SCRIPTS.items() if part in parts):
        rows += measure(script, [*start(script), "--headless"], surroundings(os.environ))
    rows += scene_rows(start, surroundings) if "scene" in parts else []
    rows += drawn_rows(start, surroundings) if "drawn" in parts else []
    rows += gpu_rows(options.godot, folder) if "gpu" in parts else []
    rows += card_rows(start, surroundings) if "card" in parts else []
    target = ROOT / "build/bench.json"
    target.write_text(json.dumps(rows, indent="\t") + "\n")
    print("In a game, with the release library" if options.release else "In an editor's engine, with the debug library")
    print("\n".join([table(rows), "", *bench_summary.lines(rows), "", str(target.relative_to(ROOT))]))
    plot(rows)
    return 0


if __name__ == "__main__":
    sys.exit(main())
