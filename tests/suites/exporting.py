"""Games exported from a project for Linux, by Debian's templates of Godot, and how they are started."""

import os

from toolchain import templates

from .engine import private_home
from .result import run

TIMEOUT = 900
PRESET = """[preset.0]

name="Linux"
platform="Linux"
runnable=true
export_filter="all_resources"
include_filter=""
exclude_filter=""
export_path=""

[preset.0.options]

custom_template/debug="{debug}"
custom_template/release="{release}"
binary_format/embed_pck=false
binary_format/architecture="x86_64"
"""


def prepare(name, godot, project):
    """Imports the project. Returns the error, or None."""
    (project / "export_presets.cfg").write_text(PRESET.format(**templates.fetch()))
    return start(name, godot, project, "--import")[1]


def export(name, godot, project, kind, game):
    """(the editor's words, what went wrong or None); a game of that kind is at the path `game` then."""
    game.parent.mkdir(parents=True, exist_ok=True)
    output, problem = start(name, godot, project, f"--export-{kind}", "Linux", game)
    return output, problem or (None if game.exists() else "no game was written")


def start(name, godot, project, *words):
    return run(name, [godot, "--headless", "--path", project, *words], timeout=TIMEOUT, environment=private_home())


def surroundings(environment=os.environ):
    """Returns the environment of a game."""
    return templates.environment(private_home(environment))
