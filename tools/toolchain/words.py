"""What each word of ./run needs, and the call of scons."""

import contextlib
import os
import shutil
import subprocess
import sys

from . import godot, headers, python_tools
from .place import Missing, ROOT, TOOLCHAIN, environment_with, say

# Words that neither compile nor start Godot.
LIGHT_WORDS = {"lint"}
PICTURE_WORDS = {"demo", "guide", "store"}
PLOT_WORDS = {"bench"}
DRAWING_WORDS = {"demo", "guide", "store", "test", "bench", "bench_scene"}
# Suites of `test` that need no engine.
CORE_SUITES = {"tools", "core", "asan", "tsan", "species"}


def targets_of(words):
    """The words that name targets: no options and no NAME=value."""
    return [word for word in words if not word.startswith("-") and "=" not in word]


def needs_godot(words):
    """False for words that neither start the engine nor need its API."""
    targets = set(targets_of(words)) or {"build"}
    suites = [word[len("suites="):] for word in words if word.startswith("suites=")]
    core_only = targets == {"test"} and bool(suites) and set(suites[-1].split(",")) <= CORE_SUITES
    return bool(targets - LIGHT_WORDS) and not core_only


def ignores_usual_folders(words):
    """True for compilers that do not search this machine's folders of headers, where Debian's packages can be unpacked."""
    return sys.platform.startswith("linux") and bool({"platform=web", "platform=android"} & set(words))


def environment_for(words):
    """The environment in which scons finds all that the words need; fetches what is missing."""
    targets = set(targets_of(words)) or {"build"}
    changes = {"PATH": [TOOLCHAIN / "bin"], "PYTHONPATH": []}
    if targets & PICTURE_WORDS:
        folder = python_tools.picture_folder()
        changes["PYTHONPATH"] += [folder] if folder else []
    if targets & PLOT_WORDS:
        with contextlib.suppress(Missing):  # what was measured is worth having without its plot; bench says so
            folder = python_tools.plot_folder()
            changes["PYTHONPATH"] += [folder] if folder else []
    if "lint" in targets:
        changes["PYTHONPATH"].append(python_tools.formatter_folder())
    if needs_godot(words):
        changes["GODOT"] = godot.find()
    if targets - LIGHT_WORDS:
        changes["CPLUS_INCLUDE_PATH"] = headers.include_folders(() if ignores_usual_folders(words) else headers.USUAL_FOLDERS)
    if targets & DRAWING_WORDS and needs_godot(words):
        bring_display()
    return changes


def bring_display():
    """Fetches a virtual display where the machine has none and no program to make one."""
    path = os.pathsep.join([str(TOOLCHAIN / "bin"), os.environ.get("PATH", "")])
    if sys.platform.startswith("linux") and not shutil.which("Xvfb", path=path):
        with contextlib.suppress(Missing):  # the one suite or word that needs it will say so
            godot.fetch()


def run_scons(words):
    changes = environment_for(words)
    command, folders = python_tools.scons_command()
    changes["PYTHONPATH"] += folders
    changes = {name: value for name, value in changes.items() if value != []}
    jobs = [] if any(word.startswith("-j") for word in words) else [f"-j{os.cpu_count() or 1}"]
    environment = environment_with(PYTHONDONTWRITEBYTECODE="1", **changes)
    return subprocess.run([*command, "-Q", *jobs, *words], cwd=ROOT, env=environment).returncode


def run_godot(arguments):
    program = godot.find()
    if os.name == "posix":
        os.execv(program, [program, *arguments])
    return subprocess.run([program, *arguments]).returncode


def main(words, usage):
    """Does what the words say and returns the exit status. Whatever can't be had ends in one message."""
    try:
        if words[:1] in (["-h"], ["--help"], ["help"]):
            print(usage.strip())
            return 0
        return run_godot(words[1:]) if words[:1] == ["godot"] else run_scons(words)
    except Missing as missing:
        say(f"\n{missing}")
        return 1
    except KeyboardInterrupt:
        return 130
