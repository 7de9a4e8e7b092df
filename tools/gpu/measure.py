"""Runs tests/bench/gpu_bench.gd on Mesa's null device, once for each card, and makes rows of what its logs contain."""

import json
import os
import shlex
import subprocess
from pathlib import Path

from toolchain import display, radv, unpacked
from toolchain.place import Missing, ROOT, TOOLCHAIN, say

from . import log as logs
from .cards import CARDS

SOURCES = Path(__file__).parent / "layer"
BUILD = ROOT / "build/gpu"
LAYER = "VK_LAYER_UNDERGROWTH_null_device"
SCREEN = (1920, 1080)
SIZE = "{}x{}".format(*SCREEN)
FLAGS = ["-std=c++17", "-O1", "-fPIC", "-shared", "-fvisibility=hidden", "-Wall", "-Wextra", "-Wshadow",
         "-Wno-missing-field-initializers", "-Werror"]
SCRIPT = "res://tests/bench/gpu_bench.gd"
TIMEOUT = 900  # s for one card.


def rows(godot, project, surroundings, counts):
    """The rows of all cards, with scenes of `counts` plants. `project` is the folder of the project that has tests/bench;
    `surroundings` changes an environment. Raises Missing where the driver cannot be had."""
    driver = radv.fetch()
    prepare(driver)
    found = []
    for card in CARDS:
        log, scenes = run(godot, project, surroundings, counts, driver, card)
        found += rows_of(card, log, scenes)
    return found


def prepare(driver):
    """Compiles the layer into build/gpu, and writes there what Vulkan's loader reads."""
    BUILD.mkdir(parents=True, exist_ok=True)
    library = BUILD / "liblayer.so"
    sources = sorted(SOURCES.glob("*.cpp"))
    if not library.exists() or library.stat().st_mtime < max(path.stat().st_mtime for path in SOURCES.iterdir()):
        compiler = shlex.split(os.environ.get("CXX") or "g++")
        words = [*compiler, *FLAGS, "-isystem", str(driver.headers), *map(str, sources), "-o", str(library)]
        answer = subprocess.run(words, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        if answer.returncode != 0:
            (BUILD / "compiler.txt").write_text(answer.stdout)
            raise Missing(f"the layer of tools/gpu cannot be compiled ({(BUILD / 'compiler.txt').relative_to(ROOT)})")
    manifest = {"name": LAYER, "type": "GLOBAL", "library_path": str(library), "api_version": "1.3.0",
                "implementation_version": "1", "description": "Runs the engine on a null device"}
    (BUILD / "layer.json").write_text(json.dumps({"file_format_version": "1.2.0", "layer": manifest}))
    (BUILD / "driver.json").write_text(json.dumps(driver.description))


def run(godot, project, surroundings, counts, driver, card):
    """The Log of the bench on a card, and its rows by number of plants."""
    path = BUILD / f"{card.family}.log"
    path.write_text("")
    say(f"Compiling for {card.title} ({card.family})")
    words, changes = start_words(godot, driver)
    words += ["--path", str(project), "--fixed-fps", "60", "--disable-vsync", "--rendering-method", "forward_plus",
              "--audio-driver", "Dummy", "--resolution", SIZE, "--script", SCRIPT, "--", *map(str, counts)]
    changes |= {"VK_DRIVER_FILES": str(BUILD / "driver.json"), "VK_LAYER_PATH": str(BUILD),
                "VK_INSTANCE_LAYERS": LAYER, "RADV_FORCE_FAMILY": card.family, "MESA_SHADER_CACHE_DISABLE": "1",
                "UNDERGROWTH_GPU_LOG": str(path), "UNDERGROWTH_GPU_SIZE": SIZE}
    with display.virtual(*SCREEN) as environment, open(BUILD / f"{card.family}.txt", "w", encoding="utf-8") as output:
        try:
            subprocess.run(words, stdout=output, stderr=subprocess.STDOUT, env={**surroundings(environment), **changes},
                           cwd=ROOT, timeout=TIMEOUT)
        except subprocess.TimeoutExpired:
            pass  # Without its last line it measured nothing.
    text = (BUILD / f"{card.family}.txt").read_text(encoding="utf-8", errors="replace")
    printed = [line for line in text.splitlines() if line.startswith("[{")]
    if not printed:
        raise Missing(f"the engine does not run on the null device of Mesa ({BUILD.relative_to(ROOT)}/{card.family}.txt)")
    log = logs.read(path.read_text(encoding="utf-8", errors="replace"))
    return log, {row["plants"]: row for row in json.loads(printed[-1])}


def start_words(godot, driver):
    """The words that start Godot with the driver's libraries, and changes of the environment. The script of the private
    Godot chooses a software renderer, so this starts the program itself."""
    if Path(godot).resolve() == (TOOLCHAIN / "bin/godot").resolve():
        folder = TOOLCHAIN / "godot"
        return [*unpacked.loader_words(folder, [driver.libraries]), str(folder / "usr/bin/godot")], {}
    own = os.environ.get("LD_LIBRARY_PATH")
    return [godot], {"LD_LIBRARY_PATH": ":".join([*([own] if own else []), str(driver.libraries)])}


def rows_of(card, log, scenes):
    """A row for each shader and for each scene of a log."""
    found = []
    for mark in log.frames:
        kind, name = mark.split(" ", 1)
        passes = logs.passes(log, mark, SCREEN)
        if kind == "shader":
            found.append({"name": f"gpu_{name}", "renderer": card.family, **shader_members(log, passes)})
        else:
            row = {**scenes[int(name)], "renderer": card.family, **scene_members(card, log, passes)}
            check_counts(row)
            found.append(row)
    return found


def check_counts(row):
    """Raises Missing if the layer counts other triangles than the engine reports."""
    for ours, engine in (("colour_triangles", "primitives"), ("shadow_triangles", "shadow_primitives")):
        if abs(row[ours] - row[engine]) > 0.01 * row[engine]:
            raise Missing(f"the layer counts {row[ours]:,} {ours}, and the engine {row[engine]:,} {engine}")


def shader_members(log, passes):
    """Cycles and registers by pass, of the pipeline that takes longest."""
    members = {}
    for name, draws in passes.items():
        pipelines = [log.pipelines[draw.pipeline] for draw in draws]
        if pipelines:
            slowest = max(pipelines, key=lambda pipeline: pipeline.cycles)
            members |= {f"{name}_cycles": slowest.cycles, f"{name}_registers": slowest.registers}
    return members


def scene_members(card, log, passes):
    """Vertices, triangles and milliseconds by pass. The triangles are those that the engine reports as primitives."""
    members = {}
    for name, draws in passes.items():
        members[f"{name}_vertices"] = sum(draw.vertices for draw in draws)
        members[f"{name}_triangles"] = sum(draw.indices for draw in draws) // 3
        members[f"{name}_ms"] = sum(card.milliseconds(draw.vertices, log.pipelines[draw.pipeline].cycles)
                                    for draw in draws)
    return members
