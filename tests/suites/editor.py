"""The real editor in a virtual display: uses the add-on's dock as a person would (tests/editor)."""

import fnmatch
import os
import re
import shutil

from building import project
from toolchain import display
from toolchain.place import Missing

from . import result
from .result import LOGS, ROOT, Result

FOLDER = LOGS / "editor_project"
HOME = LOGS / "editor_home"
PICTURES = LOGS / "editor_pictures"
# Those of the dock go there, and these must be among them.
PICTURES_END = ROOT / "build"
WANTED = ["dock_plant.png", "dock_wind.png", "dock_wind_panel.png", "dock_air.png", "dock_painted.png", "dock_light.png", "dock_1600.png", "dock_1920.png",
          "dock_200.png", "dock_200_light.png", "dock_200_light_wind.png"]
SCREEN = (1600, 1000)
# Those of some runs: as low as screens are, as most are, and twice as many pixels an inch.
SCREENS = {"layout": (1600, 900), "layout_1920": (1920, 1080), "again": (3000, 1800)}
# Seconds: a run without a new line in its log for this time hangs. The driver reports a running test at intervals.
# Limit of a whole run on a busy machine.
SILENCE = 300
TIMEOUT = 3600
# Consecutive runs on the same project: one that hangs or crashes does not end the next. Some scripts have runs of their
# own. The last one opens the project that all previous runs saved.
RUNS = ("actions", "pages", "layout", "layout_1920", "again")
LAYOUTS = ("layout", "layout_1920")
ALONE = {"test_again": ("again",), "test_first_clicks": ("layout",), "test_parts": ("layout",), "test_layout": LAYOUTS, "test_styles": LAYOUTS}
ACTIONS = ("test_actions", "test_bake", "test_faulty")
# 6 is the editor's word for 200 %, 2 for 100 %.
USUAL_SCALE = "interface/editor/display_scale = 2\n"
SETTINGS = {"layout": USUAL_SCALE,
            "layout_1920": USUAL_SCALE + 'interface/theme/color_preset = "Light"\n',
            "again": "interface/editor/display_scale = 6\n"}
PLUGINS = '"res://addons/undergrowth/plugin.cfg", "res://addons/editor_driver/plugin.cfg"'
PROJECT = f"""config_version=5

[application]

config/name="Undergrowth's editor tests"

[editor_plugins]

enabled=PackedStringArray({PLUGINS})

[rendering]

lights_and_shadows/directional_shadow/size=1024
lights_and_shadows/directional_shadow/soft_shadow_filter_quality=0
"""
TEST_LINE = re.compile(r"^(ok|not ok) (.*)$", re.MULTILINE)
START_LINE = re.compile(r"^start$", re.MULTILINE)
END_LINE = re.compile(r"^(\d+) passed, (\d+) failed$", re.MULTILINE)
COMPLAINT = re.compile(r"^(?:USER )?(?:SCRIPT )?(?:ERROR|WARNING): .*$", re.MULTILINE)
# While dialogs open and close, the engine's event thread may use a freed input context
# (godotengine/godot#118399 and #74548). An input method without a server gives no context, and a warning for each.
NO_INPUT_METHOD = {"XMODIFIERS": "@im=nobody"}
INPUT_METHOD_CRASH = re.compile(r"handle_crash: .*^\[\d+\] \S*libX11\S*\((?:XFilterEvent|X\w*IC\w*)\+",
                                re.MULTILINE | re.DOTALL)
ATTEMPTS = 3
# Messages of the engine in a virtual display.
EXPECTED = ("WARNING: Could not set V-Sync mode", "WARNING: XCreateIC couldn't create")


def make_project():
    """Creates a project with copies, not links, because an editor writes files into its project."""
    shutil.rmtree(FOLDER, ignore_errors=True)
    shutil.copytree(ROOT / "addons", FOLDER / "addons")
    shutil.copytree(ROOT / "tests/editor", FOLDER / "addons/editor_driver")
    (FOLDER / "project.godot").write_text(PROJECT)
    project.list_extensions(FOLDER)


def own_home(environment=os.environ, settings=""):
    """Returns an environment without editor settings, separate from those of other suites. Its caches stay: they
    spare each run a rebuild of the class help and the shaders."""
    for used in ("XDG_DATA_HOME", "XDG_CONFIG_HOME"):
        shutil.rmtree(HOME / used, ignore_errors=True)
    for picture in HOME.glob("XDG_CACHE_HOME/godot/resthumb*"):
        picture.unlink()
    folder = HOME / "XDG_CONFIG_HOME" / "godot"
    folder.mkdir(parents=True)
    if settings:
        words = f'[gd_resource type="EditorSettings" format=3]\n\n[resource]\n{settings}'
        (folder / "editor_settings-4.6.tres").write_text(words)
    names = ("XDG_DATA_HOME", "XDG_CONFIG_HOME", "XDG_CACHE_HOME")
    return {**environment, **NO_INPUT_METHOD, "GODOT_SILENCE_ROOT_WARNING": "1",
            **{name: str(HOME / name) for name in names}}


def scripts_of(run, only=None):
    """Returns the scripts of a run. Each script of tests/editor is in one run, or in those of several screens. `only`:
    patterns, separated by commas, of names without `test_`."""
    def places(name):
        return ALONE.get(name) or ("actions" if name.startswith(ACTIONS) else "pages",)

    names = sorted(path.stem for path in (ROOT / "tests/editor").glob("test_*.gd"))
    def is_wanted(name):
        return not only or any(fnmatch.fnmatch(name.removeprefix("test_"), part) for part in only.split(","))

    return [name for name in names if run in places(name) and is_wanted(name)]


def run(godot, only=None):
    """Imports the project, then runs the driver in tests/editor several times in the editor."""
    make_project()
    shutil.rmtree(PICTURES, ignore_errors=True)
    PICTURES.mkdir(parents=True)
    for old in PICTURES_END.glob("dock_*.png"):
        old.unlink()
    prepared = result.run("editor:import", [godot, "--headless", "--path", FOLDER, "--import"], silence=SILENCE,
                          timeout=TIMEOUT, environment=own_home())[1]
    if prepared:
        return Result("editor", 0, [f"the project could not be imported: {prepared}"])
    total = Result("editor")
    try:
        for name in RUNS:
            if scripts_of(name, only):
                add(total, run_once(godot, name, only))
    except Missing as missing:
        return Result("editor", 0, [str(missing).replace("\n", " ")])
    for picture in PICTURES.glob("dock_*.png"):
        shutil.copy(picture, PICTURES_END)
    total.failures += [] if only else [f"{name} was not written" for name in WANTED if not (PICTURES_END / name).exists()]
    return total


def run_once(godot, name, only=None):
    """Runs it once, and again if the engine's input methods crashed, which is not the add-on's fault."""
    before = FOLDER.with_name(FOLDER.name + "_before")
    shutil.rmtree(before, ignore_errors=True)
    shutil.copytree(FOLDER, before)
    notes = []
    for attempt in range(ATTEMPTS):
        output, problem = start_editor(godot, name, only)
        if attempt == ATTEMPTS - 1 or not INPUT_METHOD_CRASH.search(output):
            read = read_output(output, problem)
            return Result(read.name, read.passed, read.failures, notes)
        notes.append(f"{name} was begun once more: the engine's thread for X11 input methods crashed")
        keep_log(name, attempt)
        shutil.rmtree(FOLDER)
        shutil.copytree(before, FOLDER)


def keep_log(name, attempt):
    """Preserves the log of a repeated run beside that of the next."""
    log = LOGS / f"editor-{name}.log"
    shutil.copy(log, log.with_name(f"editor-{name}-crashed-{attempt + 1}.log"))


def start_editor(godot, name, only=None):
    words = [godot, "--editor", "--path", FOLDER, "--rendering-method", "gl_compatibility", "--audio-driver", "Dummy",
             "--", f"--editor-tests={','.join(scripts_of(name, only))}", f"--pictures={PICTURES}"]
    with display.virtual(*SCREENS.get(name, SCREEN), window_manager=True) as environment:
        environment = own_home(environment, SETTINGS.get(name, ""))
        return result.run(f"editor:{name}", words, timeout=TIMEOUT, environment=environment, silence=SILENCE)


def add(total, part):
    total.passed += part.passed
    total.failures += part.failures
    total.notes += part.notes


def read_output(output, problem):
    """Counts `ok` and `not ok`; the driver's last line must have the same numbers. Tests claim messages in the log;
    before and after them it must have none."""
    lines = TEST_LINE.findall(output)
    passed = sum(word == "ok" for word, _ in lines)
    failures = [text for word, text in lines if word == "not ok"]
    start, end = START_LINE.search(output), END_LINE.search(output)
    if not end or (int(end.group(1)), int(end.group(2))) != (passed, len(failures)) or not lines:
        failures.append(f"ended early: {problem or 'no summary'}")
    elif problem and not failures:
        failures.append(problem)
    outside = output[:start.start() if start else None] + (output[end.end():] if end else "")
    failures += [line for line in COMPLAINT.findall(outside) if not line.startswith(EXPECTED)]
    return Result("editor", passed, failures)
