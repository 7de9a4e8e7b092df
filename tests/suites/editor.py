"""The real editor in a virtual display: the add-on's dock used as a person would (tests/editor)."""

import re
import shutil

from building import project
from toolchain import display
from toolchain.place import Missing

from . import result
from .engine import private_home
from .result import LOGS, ROOT, Result

FOLDER = LOGS / "editor_project"
PICTURES = LOGS / "editor_pictures"
SCREEN = (1600, 1000)
TIMEOUT = 300
PLUGINS = '"res://addons/undergrowth/plugin.cfg", "res://addons/editor_driver/plugin.cfg"'
PROJECT = f"""config_version=5

[application]

config/name="Undergrowth's editor tests"

[editor_plugins]

enabled=PackedStringArray({PLUGINS})
"""
TEST_LINE = re.compile(r"^(ok|not ok) (.*)$", re.MULTILINE)
END_LINE = re.compile(r"^(\d+) passed, (\d+) failed$", re.MULTILINE)


def make_project():
    """A project with copies, not links: an editor writes beside what it finds."""
    shutil.rmtree(FOLDER, ignore_errors=True)
    shutil.copytree(ROOT / "addons", FOLDER / "addons")
    shutil.copytree(ROOT / "tests/editor", FOLDER / "addons/editor_driver")
    (FOLDER / "project.godot").write_text(PROJECT)
    project.list_extensions(FOLDER)


def run(godot):
    """Imports the project, then lets the driver in tests/editor use the editor."""
    make_project()
    PICTURES.mkdir(parents=True, exist_ok=True)
    prepared = result.run("editor:import", [godot, "--headless", "--path", FOLDER, "--import"], timeout=TIMEOUT,
                          environment=private_home())[1]
    if prepared:
        return Result("editor", 0, [f"the project could not be imported: {prepared}"])
    words = [godot, "--editor", "--path", FOLDER, "--rendering-method", "gl_compatibility", "--audio-driver", "Dummy",
             "--", "--editor-tests=all", f"--pictures={PICTURES}"]
    try:
        with display.virtual(*SCREEN, window_manager=True) as environment:
            output, problem = result.run("editor", words, timeout=TIMEOUT, environment=private_home(environment))
    except Missing as missing:
        return Result("editor", 0, [str(missing).replace("\n", " ")])
    return read_output(output, problem)


def read_output(output, problem):
    """Counts `ok` and `not ok`; the driver's last line must tell the same."""
    lines = TEST_LINE.findall(output)
    passed = sum(word == "ok" for word, _ in lines)
    failures = [text for word, text in lines if word == "not ok"]
    end = END_LINE.search(output)
    if not end or (int(end.group(1)), int(end.group(2))) != (passed, len(failures)) or not lines:
        failures.append(f"ended early: {problem or 'no summary'}")
    elif problem and not failures:
        failures.append(problem)
    return Result("editor", passed, failures)
