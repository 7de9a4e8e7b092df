"""Python packages in .toolchain/: SCons for every word, the formatters for `lint`, Pillow for pictures,
matplotlib for the plot of `bench`."""

import importlib.util
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

from . import debian
from .place import Missing, environment_with, make_folder, say

OLDEST_SCONS = (4, 0)
SCONS = ["scons==4.11.1"]
FORMATTERS = ["clang-format==23.1.5", "gdtoolkit==4.5.0"]
PICTURES = ["Pillow==12.0.0"]
PLOTS = ["matplotlib==3.10.8"]


def pip_command(scratch):
    """How to call pip: the one of this Python, else Debian's wheel of it, unpacked below `scratch`."""
    if importlib.util.find_spec("pip"):
        return [sys.executable, "-m", "pip"]
    remedy = "Install pip for this Python (Debian: apt install python3-pip) and run again."
    debian.unpack("pip", ["python3-pip-whl"], scratch, remedy)
    wheels = list(Path(scratch).glob("usr/share/python-wheels/pip-*.whl"))
    if not wheels:
        raise Missing(f"Debian's package python3-pip-whl holds no pip.\n{remedy}")
    return [sys.executable, str(wheels[0] / "pip")]


def fetch(name, requirements):
    """The folder .toolchain/<name> with `requirements` in it, ready for PYTHONPATH."""

    def fill(folder):
        scratch = folder / "pip"
        scratch.mkdir()
        pip = pip_command(scratch)
        say(f"Fetching {', '.join(requirements)} (pip, privately)")
        result = subprocess.run(
            [*pip, "install", "--quiet", "--disable-pip-version-check", "--no-warn-script-location",
             "--target", str(folder / "packages"), *requirements],
            env={**os.environ, "PIP_ROOT_USER_ACTION": "ignore"},
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        shutil.rmtree(scratch, ignore_errors=True)
        if result.returncode != 0:
            raise Missing(f"pip could not fetch {', '.join(requirements)}:\n{debian.last_lines(result.stdout)}\n"
                          "Give this machine a package index, or install them yourself "
                          f"(pip install {' '.join(requirements)}).")

    content = f"python {sys.version_info[0]}.{sys.version_info[1]}: {' '.join(requirements)}"
    return make_folder(name, content, fill) / "packages"


def scons_version(text):
    """The version (major, minor) in what `scons --version` prints; None where there is none."""
    found = re.search(r"SCons: v(\d+)\.(\d+)", text)
    return (int(found.group(1)), int(found.group(2))) if found else None


def scons_command():
    """(words that start SCons, folders for PYTHONPATH): the machine's own where it is new enough, else a private one."""
    own = shutil.which("scons")
    if own:
        answer = subprocess.run([own, "--version"], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        if (scons_version(answer.stdout) or (0, 0)) >= OLDEST_SCONS:
            return [own], []
    return [sys.executable, "-m", "SCons"], [fetch("scons", SCONS)]


def scons(**changes):
    """(words that start SCons, its environment with `changes`)."""
    command, folders = scons_command()
    return command, environment_with(PYTHONPATH=folders, **changes)


def formatter_folder():
    """The folder for PYTHONPATH that holds clang-format and gdtoolkit."""
    return fetch("formatters", FORMATTERS)


def picture_folder():
    """The folder for PYTHONPATH that holds Pillow; None where this Python has it already."""
    return None if importlib.util.find_spec("PIL") else fetch("pictures", PICTURES)


def plot_folder():
    """The folder for PYTHONPATH that holds matplotlib; None where this Python has it already."""
    return None if importlib.util.find_spec("matplotlib") else fetch("plots", PLOTS)
