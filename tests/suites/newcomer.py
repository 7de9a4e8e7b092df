"""The first use of the zip in an empty project: the first start of the editor with the plugin off, on and
switched, the add-on copied into a running editor, a library that is missing, and the first field."""

import os
import shutil

from shipping import archive
from toolchain.place import Missing

from . import engine, shipped
from .result import LOGS, ROOT, Result, run

FOLDER = LOGS / "newcomer"
DRIVER = "res://addons/driver/plugin.cfg"
PLUGIN = "res://addons/undergrowth/plugin.cfg"
TIMEOUT, SILENCE = 600, 120
# Messages about a missing library: the engine's and the plugin's.
NOT_FOUND = "GDExtension dynamic library not found"
NO_FILE = 'Condition "!FileAccess::exists(path)" is true'
PLUGIN_SAYS = "Undergrowth: its library for this platform is missing"


def suites(godot):
    names = [name for name in globals() if name.startswith("try_")]
    return [(f"package:{name[4:]}", lambda name=name: attempt(name, godot)) for name in names]


def attempt(name, godot):
    try:
        return globals()[name](f"package:{name[4:]}", godot)
    except Missing as missing:
        return Result(f"package:{name[4:]}", 0, [str(missing)])


def settings(*plugins):
    names = ", ".join(f'"{plugin}"' for plugin in plugins)
    return f"\n[editor_plugins]\n\nenabled=PackedStringArray({names})\n"


def make_project(name, *plugins):
    """Creates a fresh clone without editor files."""
    folder = shipped.make_project(FOLDER / name, settings(*plugins))
    shutil.copytree(ROOT / "tests/package/driver", folder / "addons/driver")
    return folder


def unused_home(name):
    """Returns an environment without editor settings that no other editor uses."""
    home = FOLDER / f"home_{name}"
    shutil.rmtree(home, ignore_errors=True)
    names = ("XDG_DATA_HOME", "XDG_CONFIG_HOME", "XDG_CACHE_HOME")
    return {**os.environ, "GODOT_SILENCE_ROOT_WARNING": "1", **{name: str(home / name.lower()) for name in names}}


def open_editor(name, godot, folder, *words):
    """(the output, Result) of the driver in a headless editor."""
    scenario = name.split(":")[1]
    command = [godot, "--headless", "--editor", "--path", folder, "--", f"--scenario={scenario}", *words]
    output, problem = run(name, command, timeout=TIMEOUT, silence=SILENCE, environment=unused_home(scenario))
    return output, engine.read_output(name, output, problem)


def silent(name, godot, folder, *words):
    """The same as open_editor. Errors and warnings of the engine fail."""
    output, result = open_editor(name, godot, folder, *words)
    result.failures += [line for line in shipped.complaints(output) if line not in result.failures]
    return result


def try_off(name, godot):
    return silent(name, godot, make_project("off", DRIVER))


def try_on(name, godot):
    return silent(name, godot, make_project("on", PLUGIN, DRIVER))


def try_switched(name, godot):
    return silent(name, godot, make_project("switched", DRIVER))


def try_copied(name, godot):
    folder = make_project("copied", DRIVER)
    shutil.rmtree(FOLDER / "to_copy", ignore_errors=True)
    shutil.move(folder / archive.ADDON, FOLDER / "to_copy")
    return silent(name, godot, folder, f"--from={FOLDER / 'to_copy'}")


def try_missing(name, godot):
    """With the plugin off the engine reports it, which README explains. With the plugin on, the plugin does too."""
    total = Result(name)
    for plugins, sentences in (((DRIVER,), (NOT_FOUND,)), ((PLUGIN, DRIVER), (NOT_FOUND, PLUGIN_SAYS))):
        folder = make_project("missing", *plugins)
        shutil.rmtree(folder / archive.ADDON / "bin")
        output, result = open_editor(name, godot, folder)
        total.passed += result.passed
        total.failures += [failure for failure in result.failures
                           if not any(sentence in failure for sentence in (*sentences, NO_FILE))]
        total.failures += [f"it did not say: {sentence}" for sentence in sentences if sentence not in output]
    return total


def try_first_field(name, godot):
    """The plugin is off: a game from the command line."""
    folder = shipped.make_test_project(FOLDER / "first_field")
    shutil.copy(ROOT / "tests/package/newcomer.gd", folder)
    words = [godot, "--headless", "--path", folder, *engine.STEADY, "--script", "res://newcomer.gd"]
    return engine.read_output(name, *run(name, words, timeout=TIMEOUT, environment=engine.private_home()))
