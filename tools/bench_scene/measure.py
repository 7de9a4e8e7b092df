#!/usr/bin/env python3
"""Draws one scene along one camera path; writes its figures to one JSON file, and one picture.

It runs on any machine with Godot and the add-on's library: `./run bench_scene`, or without SCons
`python3 tools/bench_scene/measure.py --godot=PATH`. On Linux without a display it draws in a virtual one, in software.
README.md lists the figures and explains how to measure other add-ons in the same scene."""

import argparse
import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))

from building import project  # noqa: E402  (the path above comes first)
from toolchain import display  # noqa: E402
from toolchain.place import Missing  # noqa: E402

HERE = Path(__file__).resolve().parent
TIMEOUT = 3600  # s: a software renderer on a busy machine.
IMPORT_TIMEOUT = 300  # s
TIMES = [f"{name}_{part}_ms" for name in ("frame", "main", "render", "gpu") for part in ("p50", "p99", "worst")]
COUNTS = [before + name for name in ("draw_calls", "shadow_draw_calls", "primitives", "shadow_primitives")
          for before in ("", "max_")]
MEMORY = ["video_mb", "plants_video_mb", "resident_mb", "plants_resident_mb"]
FIGURES = [*TIMES, "processor_ms", "fill_ms", "build_ms", *COUNTS, *MEMORY, "errors"]
# A machine without a graphics card has no time of it, and only Linux reports these figures of a process.
MAY_BE_NULL = {"gpu_p50_ms", "gpu_p99_ms", "gpu_worst_ms", "processor_ms", "resident_mb", "plants_resident_mb"}
# The file by which each other add-on is found in its folder.
OTHERS = {"simple_grass_textured": "addons/simplegrasstextured/grass.gd", "godot_grass": "assets/grass/mat_grass.tres"}
# The sections of its project's settings that its shaders and scripts need, and the lines of them.
KEPT = {"shader_globals": re.compile(""), "autoload": re.compile("SimpleGrass")}
SETTINGS = """config_version=5

[application]

config/name="Undergrowth's bench scene"

[display]

window/vsync/vsync_mode=0
"""
ERROR = re.compile(r"^(?:SCRIPT |USER |SHADER )?ERROR: .*", re.MULTILINE)
# Of machines, not of the scene.
EXPECTED = re.compile(r"ERROR: .*(?:as root|XDG_RUNTIME_DIR|audio driver|default_texture_filter)")


def missing_figures(report):
    """The figures that the report lacks, or that are no numbers."""
    figures = report.get("figures", {})
    return [name for name in FIGURES
            if not (isinstance(figures.get(name), (int, float)) or (name in MAY_BE_NULL and name in figures))]


def errors_in(output):
    """The errors in an engine's output."""
    return [line for line in ERROR.findall(output) if not EXPECTED.search(line)]


def kind_in(folder):
    """The name of the other add-on whose files the folder holds."""
    for name, file in OTHERS.items():
        if (folder / file).is_file():
            return name
    sys.exit(f"{folder} has none of the files {', '.join(OTHERS.values())}. See tools/bench_scene/README.md.")


def settings_of(text):
    """The parts of another project's settings that are needed to draw its plants."""
    parts = re.split(r"^\[(\w+)\]$", text, flags=re.MULTILINE)[1:]
    found = ""
    for section, content in zip(parts[0::2], parts[1::2]):
        if section in KEPT:
            entries = re.split(r"^(?=[\w/]+=)", content, flags=re.MULTILINE)[1:]
            found += f"\n[{section}]\n\n" + "".join(entry for entry in entries if KEPT[section].match(entry))
    return found


def make_project(folder, other):
    """A project with the add-on and, for another add-on, a copy of its project, since the import writes beside files."""
    shutil.rmtree(folder, ignore_errors=True)
    settings = SETTINGS
    if other:
        shutil.copytree(other, folder, ignore=shutil.ignore_patterns(".git", ".godot", "undergrowth"))
        old = folder / "project.godot"
        settings += settings_of(old.read_text(encoding="utf-8")) if old.exists() else ""
    (folder / "addons").mkdir(parents=True, exist_ok=True)
    (folder / "project.godot").write_text(settings, encoding="utf-8")
    project.link(ROOT / "addons/undergrowth", folder / "addons/undergrowth")
    project.link(HERE, folder / "bench_scene")
    project.list_extensions(folder)
    project.list_uids(folder)


def start(words, environment, timeout):
    """Runs the engine; returns its output and status."""
    done = subprocess.run(words, env=environment, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True, errors="replace", timeout=timeout)
    return done.stdout, done.returncode


def measure(options, folder, out, picture):
    """The report of one run, with the errors that the engine logged."""
    other = Path(options.other).resolve() if options.other else None
    kind = kind_in(other) if other else ""
    make_project(folder, other)
    words = [options.godot, "--path", str(folder)]
    out.unlink(missing_ok=True)
    drawn = [*words, "--rendering-method", options.method, "--audio-driver", "Dummy", "--fixed-fps", "60", "--disable-vsync",
             "--resolution", options.size, "--script", "res://bench_scene/bench_scene.gd", "--", f"--out={out}",
             f"--picture={picture}", f"--plants={options.plants}", f"--frames={options.frames}", f"--size={options.size}",
             *([f"--other={kind}"] if kind else [])]
    width, height = map(int, options.size.split("x"))
    if other:
        start([*words, "--headless", "--import"], dict(os.environ), IMPORT_TIMEOUT)
    if display.has_display():
        output, status = start(drawn, dict(os.environ), TIMEOUT)
    else:
        with display.virtual(width, height) as environment:
            output, status = start(drawn, environment, TIMEOUT)
    if status != 0 or not out.exists():
        sys.exit(f"The scene was not measured (exit status {status}):\n{output[-3000:]}")
    report = json.loads(out.read_text(encoding="utf-8"))
    errors = errors_in(output)
    report["figures"]["errors"] = len(errors)
    report["first_errors"] = errors[:5]
    out.write_text(json.dumps(report, indent="\t") + "\n", encoding="utf-8")
    return report


def lines(report):
    """The report as text: one line for the scene, one for each figure."""
    scene, machine = report["scene"], report["machine"]
    head = (f"{scene['kind']}: {scene['plants']:,} plants, {scene['frames']} frames of {scene['pixels']}, "
            f"{machine['renderer']} on {machine['adapter']}")
    figures = [f"  {name:<24}{'-' if report['figures'][name] is None else format(report['figures'][name], '.6g'):>12}"
               for name in FIGURES]
    return [head, *figures, *(f"  {error}" for error in report["first_errors"])]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--godot", default=os.environ.get("GODOT") or shutil.which("godot"), help="the engine")
    parser.add_argument("--plants", type=int, default=100_000, help="number of plants, or of blades of another add-on")
    parser.add_argument("--frames", type=int, default=600, help="frames along the path")
    parser.add_argument("--size", default="1920x1080", help="pixels")
    parser.add_argument("--method", default="forward_plus", choices=["forward_plus", "mobile", "gl_compatibility"])
    parser.add_argument("--other", default="", help="folder of a project with another add-on, which is drawn instead")
    parser.add_argument("--out", default=str(ROOT / "build/bench_scene.json"), help="the JSON file; the picture lies beside")
    options = parser.parse_args()
    if not options.godot:
        parser.error("Godot is missing: pass --godot=PATH")
    out = Path(options.out).resolve()
    out.parent.mkdir(parents=True, exist_ok=True)
    picture = out.with_suffix(".png")
    try:
        report = measure(options, out.with_suffix(""), out, picture)
    except Missing as missing:
        sys.exit(str(missing))
    print("\n".join([*lines(report), str(out), str(picture)]))
    missing = missing_figures(report)
    if missing:
        sys.exit("Figures are missing: " + ", ".join(missing))
    return 0


if __name__ == "__main__":
    sys.exit(main())
