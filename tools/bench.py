#!/usr/bin/env python3
"""Measures the core and the add-on, in a headless engine and in renderers without a graphics card.

Prints a table and what it means, writes build/bench.json and build/bench.png. All measuring programs print a JSON list
of rows {"name", "plants", "threads", "median_ms", "us_per_plant"}; rows of fields also tell their "renderer".
"""

import argparse
import json
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "tests"))

import bench_plot  # noqa: E402  (the path above comes first)
import bench_summary  # noqa: E402
from suites import engine  # noqa: E402
from toolchain import display  # noqa: E402
from toolchain.place import Missing  # noqa: E402

COLUMNS = ("name", "plants", "threads", "median_ms", "us_per_plant", "renderer")
RENDERERS = ("forward_plus", "gl_compatibility")
TIMEOUT = 600
ENGINE_SCRIPTS = {"plants": "engine_bench", "fields": "field_bench", "edits": "edits_bench"}
PARTS = ("core", *ENGINE_SCRIPTS, "drawn")
# The engine's better physics has to be chosen, and told how many bodies there will be.
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


def measure(name, words, environment=None):
    """The rows that a program prints; it shows the program's words and stops where there are none."""
    answer = subprocess.run(words, stdout=subprocess.PIPE, text=True, timeout=TIMEOUT, env=environment, cwd=ROOT)
    try:
        return rows_in(answer.stdout)
    except ValueError as error:
        sys.exit(f"{name} measured nothing ({error}, exit status {answer.returncode}):\n{answer.stdout[-2000:]}")


def drawn_rows(start):
    """Fields in each renderer, in a virtual display; nothing where there is none."""
    rows = []
    for method in RENDERERS:
        words = [*start, "--rendering-method", method, "--audio-driver", "Dummy", "--resolution", "320x180",
                 "--script", "res://tests/bench/field_bench.gd"]
        try:
            with display.virtual(640, 360) as environment:
                rows += measure(f"field_bench in {method}", words, engine.private_home(environment))
        except Missing as missing:
            print(f"{method} is not measured: {missing}")
    return rows


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
    parser.add_argument("--parts", default=",".join(PARTS), help="what to measure: some of " + ", ".join(PARTS))
    options = parser.parse_args()
    parts = set(options.parts.split(","))
    if not parts <= set(PARTS):
        parser.error(f"no such part: {', '.join(sorted(parts - set(PARTS)))}; there are {', '.join(PARTS)}")
    rows = measure("core_bench", [options.core]) if options.core and "core" in parts else []
    folder = engine.make_project("bench_project", {"tests/bench": "tests/bench"})
    with open(folder / "project.godot", "a", encoding="utf-8") as settings:
        settings.write(JOLT)
    start = [options.godot, "--path", str(folder), "--fixed-fps", "60", "--disable-vsync"]
    for script in (name for part, name in ENGINE_SCRIPTS.items() if part in parts):
        words = [*start, "--headless", "--script", f"res://tests/bench/{script}.gd"]
        rows += measure(script, words, engine.private_home())
    rows += drawn_rows(start) if "drawn" in parts else []
    target = ROOT / "build/bench.json"
    target.write_text(json.dumps(rows, indent="\t") + "\n")
    print("\n".join([table(rows), "", *bench_summary.lines(rows), "", str(target.relative_to(ROOT))]))
    plot(rows)
    return 0


if __name__ == "__main__":
    sys.exit(main())
