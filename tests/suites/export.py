"""Games that are exported for real: the demo project with the add-on from the zip, by Debian's templates of Godot, both
kinds, run headless and drawn; and what the export says where the add-on's library is missing. Not among the suites of the
plain test: `./run package` first, then `./run test suites=export`.
"""

import os
import shutil

from building import project
from shipping import archive
from toolchain import display, templates
from toolchain.place import Missing

from . import engine, exporting, picture, shipped
from .result import LOGS, ROOT, Result, run

FOLDER = LOGS / "export"
PROJECT = FOLDER / "project"
SIZE = (640, 360)
# Message of this template for every box container at the end of a game, also without the add-on.
EXPECTED = (*shipped.EXPECTED, "ERROR: Attempt to disconnect a nonexistent connection")
AUTOLOAD = '\n[autoload]\n\nGameTest="*res://game_test.gd"\n'
MISSING = "is missing: the game will have no plants"


def suites(godot):
    return [("export", lambda: export(godot))]


def make_project():
    """Creates the demo project with the add-on from the zip, and the script that tests the game from within."""
    shutil.rmtree(FOLDER, ignore_errors=True)
    shutil.copytree(ROOT / "demo_project", PROJECT, ignore=shutil.ignore_patterns("addons", ".godot"))
    shipped.unpack(PROJECT)
    shutil.copy(ROOT / "tests/package/game_test.gd", PROJECT)
    with open(PROJECT / "project.godot", "a", encoding="utf-8") as settings:
        settings.write(AUTOLOAD)
    project.list_extensions(PROJECT)


def export(godot):
    """Exports and runs both kinds, and exports again without the game's library."""
    try:
        make_project()
        total = Result("export")
        problem = exporting.prepare("export:import", godot, PROJECT)
        if problem:
            return Result("export", 0, [f"the project could not be imported: {problem}"])
        for kind in templates.KINDS:
            add(total, try_kind(godot, kind))
        add(total, try_without(godot))
        return total
    except Missing as missing:
        return Result("export", 0, [str(missing).replace("\n", " ")])


def add(total, part):
    total.passed += part.passed
    total.failures += [f"{part.name}: {failure}" for failure in part.failures]


def complaints(output):
    return shipped.complaints(output, EXPECTED)


def try_kind(godot, kind):
    """Tests a game of that kind: it exports without errors, and game_test.gd passes in it."""
    game = FOLDER / kind / "game"
    output, problem = exporting.export(f"export:{kind}", godot, PROJECT, kind, game)
    wrong = complaints(output) + ([problem] if problem else [])
    if wrong:
        return Result(f"{kind} export", 0, wrong)
    total = Result(kind, 1)
    add(total, play(kind, game))
    with display.virtual(*SIZE) as environment:
        add(total, play(kind, game, environment))
    return total


def play(kind, game, environment=None):
    """Runs the game headless, or drawn where there is an `environment` with a display."""
    name, picture_path = f"{kind}-drawn" if environment else f"{kind}-headless", game.parent / "picture.png"
    words = ["--fixed-fps", "60", "--audio-driver", "Dummy"]
    words += [] if environment else ["--headless"]
    words += ["--resolution", "{}x{}".format(*SIZE), "--", f"--picture={picture_path}"] if environment else []
    output, problem = run(f"export:{name}", [game, *words], timeout=exporting.TIMEOUT, folder=game.parent,
                          environment=exporting.surroundings(environment or os.environ))
    read = engine.read_output(name, output, problem)
    # A release template buffers the output of a game, so that all errors seem to be before `start`.
    failures = [failure for failure in read.failures if not failure.startswith(EXPECTED)]
    failures += [line for line in complaints(output) if line not in failures]
    if environment and not failures:
        _, _, rows, size = picture.read_png(picture_path)
        green = picture.share(map(picture.is_green, picture.pixels(rows, size)))
        failures += [] if green > picture.MIN_GREEN else [f"{100 * green:.1f} % of its picture is green plants"]
    return Result(name, read.passed + (1 if environment and not failures else 0), failures)


def try_without(godot):
    """Checks that the export reports the missing library of the game and its solution."""
    library = next((PROJECT / archive.ADDON / "bin").glob("*linux.template_release.x86_64*"))
    library.unlink()
    output, _ = exporting.export("export:without", godot, PROJECT, "release", FOLDER / "without" / "game")
    told = [line for line in complaints(output) if MISSING in line and library.name in line]
    wrong = [] if len(told) == 1 else [f"it was reported {len(told)} times, not once"]
    return Result("without a library", int(not wrong), wrong)
