"""Dry runs of the real SConstruct, in a checkout of their own."""

import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))

from toolchain import python_tools


def make_checkout(folder):
    """A folder with this checkout's sources, and with nothing that was built."""
    for name in ("build", "demo_project"):
        (folder / name).mkdir(parents=True)
    for name in ("SConstruct", "addons", "extension", "tests", "tools"):
        (folder / name).symlink_to(ROOT / name)


def dry_run(checkout, *words, without=(), **environment):
    """(exit status, output) of `scons WORDS` in `checkout`; `without`: variables that are unset."""
    command, variables = python_tools.scons(**environment)
    for name in without:
        variables.pop(name, None)
    done = subprocess.run([*command, "-Q", "-n", "verbose=yes", *words], cwd=checkout, env=variables,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    return done.returncode, done.stdout
