"""Suites in a headless engine: one process for each test script, so that a crash ends no other test."""

import dataclasses
import fnmatch
import itertools
import os
import re
import shutil
import threading
from pathlib import Path

from building import project
from toolchain import display
from toolchain.place import Missing

from .result import LOGS, ROOT, Result, run

_own = threading.local()
_numbers = itertools.count()

PROJECT = """config_version=5

[application]

config/name="Undergrowth's tests"
"""
# The add-on's description if the recorder starts it.
RECORDED = """[configuration]

entry_symbol = "recorded_init"
compatibility_minimum = "4.5"

[libraries]

linux.x86_64 = "res://recorder/librecorder.so"
linux.arm64 = "res://recorder/librecorder.so"
"""
# Messages of the engine about objects, resources or memory that outlive it. Each of them is an error.
LEAK = re.compile(r"leaked|still in use at exit|Leaked instance|Orphan StringName|RID allocations", re.IGNORECASE)
TEST_LINE = re.compile(r"^(ok|not ok) (.*)$", re.MULTILINE)
# No test can claim messages before this line, while the engine loads the extension.
START = "\nstart\n"
# The dummy renderer of the headless engine is not thread-safe. The real ones are.
# Rendering methods of a script in a virtual display.
DRAWN = {"threads": ["gl_compatibility"], "threads_first_mesh": ["gl_compatibility"],
         "plant_bones": ["gl_compatibility"],
         "wind_shader": ["gl_compatibility", "forward_plus"],
         "shader_functions": ["gl_compatibility", "opengl3_es"],
         "model_materials": ["gl_compatibility"],
         "climber_picture": ["gl_compatibility", "opengl3_es", "forward_plus"],
         "field_picture": ["gl_compatibility", "forward_plus"],
         "field_picture_cards": ["gl_compatibility", "forward_plus"],
         "field_picture_jitter": ["gl_compatibility", "forward_plus"],
         "field_picture_light": ["gl_compatibility", "forward_plus"],
         "field_picture_msaa": ["forward_plus"],
         "field_picture_near": ["gl_compatibility", "forward_plus"],
         "field_picture_parts": ["gl_compatibility", "opengl3_es", "forward_plus"],
         "field_picture_stems": ["gl_compatibility", "forward_plus"],
         "ground_picture": ["forward_plus"],
         "field_skeletons": ["gl_compatibility", "forward_plus"],
         "field_levels": ["gl_compatibility", "forward_plus"],
         "field_widths": ["gl_compatibility", "forward_plus"],
         "field_vectors": ["forward_plus"],
         "field_scaled": ["gl_compatibility"], "field_materials_in_use": ["gl_compatibility"],
         "fields_together": ["gl_compatibility"],
         "shadows_of_parts_picture": ["gl_compatibility", "forward_plus"],
         "shadows_picture": ["gl_compatibility", "forward_plus"],
         "ready_species_albedo": ["forward_plus"],
         "guide_shaders_msaa": ["forward_plus"],
         "mesh_plants_picture": ["gl_compatibility", "forward_plus"],
         "stand_picture": ["forward_plus"],
         "ready_species_picture": ["gl_compatibility"]}
# The shading language and the formats of OpenGL ES 3.0 are those of WebGL 2.
DRIVERS = {"opengl3_es": ["--rendering-method", "gl_compatibility", "--rendering-driver", "opengl3_es"]}
# The slowest scripts, which start first.
SLOW = {"field_tile_rebuild", "species_levels", "hot_reload", "physics_thread", "field_extremes", "field_picture_cards",
        "field_picture_msaa", "field_picture_near", "field_materials_in_use", "field_vectors", "ground_picture",
        "guide_shaders_msaa", "mesh_plants_picture", "shadows_picture", "stand_picture"}
# Of all projects. In software, a shadow's picture of the usual size costs more than the plants in it.
RENDERING = "[rendering]\n\nlights_and_shadows/directional_shadow/size=2048\n"
# Additional settings in the projects of some scripts.
SETTINGS = {"physics_thread": "[physics]\n\n3d/run_on_separate_thread=true\n",
            "step_setting": "[undergrowth]\n\nsimulation/step_length=0.025\n",
            "no_physics": "[physics]\n\n3d/physics_engine=\"Dummy\"\n"}
# The library runs each task on the thread that starts it, as in a browser without threads. The engine's own setting
# for that, threading/worker_pool/max_threads=0, crashes Godot 4.6.3.
NO_WORKERS = "[undergrowth]\n\nsimulation/use_worker_threads=false\n"
# Messages of the engine in a virtual display.
EXPECTED = "WARNING: Could not set V-Sync mode"
# Each frame is a sixtieth of a second of the scene's time. The machine's load has no effect, and frames do not wait for
# the clock.
STEADY = ["--fixed-fps", "60"]
# Scripts draw in viewports of their own. Each frame of a larger window costs time.
WINDOW = "64x64"
TIMEOUT = 600  # s for one script: two cores may be busy with other suites.
END_LINE = re.compile(r"^done (\d+)$", re.MULTILINE)
# One line per round of several: `round 3 seed 17`.
ROUND_OR_TEST = re.compile(r"^(?:round \d+ seed (\d+)|(ok|not ok) (.*))$", re.MULTILINE)


@dataclasses.dataclass
class Rounds:
    """The number of rounds of a script's tests, and, with a `seed`, their random order: the
    first round uses the seed itself, and each further round the next number.

    A test that depends on another one fails in an engine's first round, one that another breaks in a later round.
    So one process runs many consecutive rounds, and there are several processes."""

    times: int = 1
    seed: int = None
    IN_A_PROCESS = 10

    def cut(self):
        """Rounds for one process each."""
        return [Rounds(min(self.IN_A_PROCESS, self.times - first), None if self.seed is None else self.seed + first)
                for first in range(0, self.times, self.IN_A_PROCESS)]

    def words(self):
        """Returns the harness's arguments."""
        words = [f"--rounds={self.times}"] if self.times > 1 else []
        words += [] if self.seed is None else [f"--seed={self.seed}"]
        return ["--", *words] if words else []


def suites(godot, probe=None, recorder=None, rounds=None, only=None):
    """One suite for each tests/engine/**/test_*.gd; those of the binding need its `probe` library, those of drawing the
    `recorder`. `only` names some,
    as in `field_*,motion`. With many `rounds` there are several suites for a script, one for each process."""
    scripts = sorted((ROOT / "tests/engine").glob("test_*.gd"))
    folder = make_project()
    folders = {name: make_project("project_" + name, settings=text) for name, text in SETTINGS.items()}
    found = [(script, folders.get(subject(script), folder), method)
             for script in scripts for method in DRAWN.get(subject(script), [None])]
    if probe:
        folder = make_probe_project(Path(probe))
        found += [(script, folder, None) for script in sorted((ROOT / "tests/engine/binding").glob("test_*.gd"))]
    if recorder:
        folder = make_recorder_project(Path(recorder))
        found += [(script, folder, None) for script in sorted((ROOT / "tests/engine/drawing").glob("test_*.gd"))]
    chosen = [one for one in found if is_wanted(one[0], only)]
    chosen.sort(key=lambda one: subject(one[0]) not in SLOW)
    parts = (rounds or Rounds()).cut()
    return [(name_of(script, method) + (f":{part + 1}" if part else ""),
             lambda script=script, folder=folder, method=method, part=part:
             run_script(godot, folder, script, method, parts[part], part))
            for part in range(len(parts)) for script, folder, method in chosen]


def without_workers(godot, only=None):
    """The headless suites again, as `single:...`, in an engine without worker threads."""
    scripts = [script for script in sorted((ROOT / "tests/engine").glob("test_*.gd"))
               if subject(script) not in DRAWN and is_wanted(script, only)]
    scripts.sort(key=lambda script: subject(script) not in SLOW)
    folder = make_project("project_single", settings=NO_WORKERS)
    folders = {name: make_project("project_single_" + name, settings=text + "\n" + NO_WORKERS)
               for name, text in SETTINGS.items()}
    return [("single:" + subject(script),
             lambda script=script: run_script(godot, folders.get(subject(script), folder), script, kind="single"))
            for script in scripts]


def subject(script):
    return script.stem[len("test_"):]


def is_wanted(script, only):
    return not only or any(fnmatch.fnmatch(subject(script), name) for name in only.split(","))


def is_headless(name):
    """True if the suite of this name, from name_of(), runs without a display."""
    return name.split(":")[1] not in DRAWN


def name_of(script, method=None, kind="engine"):
    several = len(DRAWN.get(subject(script), [])) > 1
    return kind + ":" + subject(script) + (f":{method}" if several else "")


def make_probe_project(probe):
    """A project with the binding's probe library instead of the add-on, as res://probe/."""
    folder = LOGS / "probe_project"
    shutil.rmtree(folder, ignore_errors=True)
    (folder / "probe").mkdir(parents=True)
    (folder / "project.godot").write_text(PROJECT)
    shutil.copy(ROOT / "tests/engine/binding/probe.gdextension", folder / "probe")
    shutil.copy(probe, folder / "probe")
    project.list_extensions(folder, ["res://probe/probe.gdextension"])
    (folder / "tests").mkdir()
    project.link(ROOT / "tests/engine", folder / "tests/engine")
    return folder


def make_recorder_project(recorder):
    """A project in which the recorder starts the add-on (tests/engine/drawing/README.md)."""
    folder = LOGS / "recorder_project"
    shutil.rmtree(folder, ignore_errors=True)
    add_on, place = ROOT / "addons/undergrowth", folder / "addons/undergrowth"
    place.mkdir(parents=True)
    for entry in add_on.iterdir():
        if entry.name != "undergrowth.gdextension":
            (place / entry.name).symlink_to(entry)
    (place / "undergrowth.gdextension").write_text(RECORDED)
    (folder / "recorder").mkdir()
    (folder / "project.godot").write_text(PROJECT)
    for name in ("recorder.gdextension", recorder):
        shutil.copy(ROOT / "tests/engine/drawing" / name, folder / "recorder")
    library = next((add_on / "bin").glob("libundergrowth.linux.template_debug.*.so"))
    (folder / "recorder/librecorded.so").symlink_to(library)
    project.list_extensions(folder, ["res://recorder/recorder.gdextension", project.EXTENSION])
    project.list_uids(folder)
    (folder / "tests").mkdir()
    project.link(ROOT / "tests/engine", folder / "tests/engine")
    return folder


def make_project(name="project", links=(("tests/engine", "tests/engine"),), settings=""):
    """A project build/test/<name> that holds the add-on and, by `links`, folders of the repository: {here: there}. Its
    project.godot ends in `settings`."""
    folder = LOGS / name
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    (folder / "project.godot").write_text("\n".join([PROJECT, RENDERING, settings]))
    project.prepare(folder, ROOT / "addons")
    for here, there in dict(links).items():
        (folder / here).parent.mkdir(parents=True, exist_ok=True)
        project.link(ROOT / there, folder / here)
    return folder


def private_home(environment=os.environ):
    """`environment`, changed so that the engine keeps its settings, caches and user's files below build/test. Each thread
    has its own, because engines that start together create the same folders of shaders, and report those that exist.
    Mesa's cache is for all."""
    if not hasattr(_own, "home"):
        _own.home = LOGS / f"home_{next(_numbers)}"
    folders = {"XDG_DATA_HOME": _own.home / "data", "XDG_CONFIG_HOME": _own.home / "config", "XDG_CACHE_HOME": LOGS / "cache"}
    for folder in folders.values():
        folder.mkdir(parents=True, exist_ok=True)
    # The user in a container is often root, which is not the add-on's fault.
    return {**environment, "GODOT_SILENCE_ROOT_WARNING": "1", **{name: str(folder) for name, folder in folders.items()}}


def run_script(godot, folder, script, method=None, rounds=None, part=0, kind="engine"):
    """Headless, or drawn in a virtual display by a rendering `method`: the `part`-th process with `rounds` of it."""
    name = name_of(script, method, kind) + (f":{part + 1}" if part else "")
    rounds = rounds or Rounds()
    path = "res://" + (Path("tests/engine") / script.relative_to(ROOT / "tests/engine")).as_posix()
    words = [godot, "--path", folder, *STEADY, "--script", path]
    # Tests that start another engine, for example for a frame rate, use this one.
    surroundings = {**os.environ, "GODOT": str(godot)}
    if not method:
        environment = private_home(surroundings)
        words += ["--headless", *rounds.words()]
        return read_output(name, *run(name, words, timeout=TIMEOUT * rounds.times, silence=TIMEOUT,
                                      environment=environment))
    words += [*DRIVERS.get(method, ["--rendering-method", method]), "--audio-driver", "Dummy", "--resolution", WINDOW, *rounds.words()]
    try:
        with display.virtual(640, 360) as environment:
            environment = private_home({**environment, "GODOT": str(godot)})
            return read_output(name, *run(name, words, timeout=TIMEOUT * rounds.times, silence=TIMEOUT,
                                          environment=environment))
    except Missing as missing:
        return Result(name, 0, [str(missing).replace("\n", " ")])


def read_output(name, output, problem):
    """Counts `ok` and `not ok` lines. The script's last line contains their expected number."""
    lines = TEST_LINE.findall(output)
    loading = output.partition(START)[0]
    failures = [line for line in loading.splitlines()
                if line.startswith(("ERROR:", "WARNING:")) and not line.startswith(EXPECTED)]
    failures += failed_tests(output)
    end = END_LINE.search(output)
    if not end or int(end.group(1)) != len(lines) or not lines:
        failures.append(f"ended early: {problem or last_line(output)}")
    else:
        failures += [problem] if problem and not failures else []
        failures += [line for line in output[end.end():].splitlines() if LEAK.search(line)]
    return Result(name, sum(word == "ok" for word, _ in lines), failures)


def failed_tests(output):
    """Returns the message of each failed test, and the seed of a random order."""
    failures, order = [], ""
    for seed, word, text in ROUND_OR_TEST.findall(output):
        order = f" (order=random seed={seed})" if seed else order
        failures += [text + order] if word == "not ok" else []
    return failures


def last_line(output):
    return ([line.strip() for line in output.splitlines() if line.strip()] or ["no output"])[-1]
