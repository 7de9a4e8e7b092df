"""Where the private toolchain lies, and how a folder of it comes into being: whole or not at all."""

import contextlib
import os
import shutil
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
TOOLCHAIN = ROOT / ".toolchain"
STAMP = "complete.txt"


class Missing(Exception):
    """Something that the machine lacks and that could not be fetched. The text names it and the remedy."""


def say(text):
    """One line of progress, on standard error so that a program's own output stays clean."""
    print(text, file=sys.stderr, flush=True)


def is_complete(name, content):
    """True when .toolchain/<name> was made to its end and from the same list of contents."""
    try:
        return (TOOLCHAIN / name / STAMP).read_text() == content
    except OSError:
        return False


def make_folder(name, content, fill):
    """Returns .toolchain/<name>, calling `fill(folder)` first unless it is there already.

    `content` describes what is inside, pinned versions included; another description makes the folder anew.
    The folder is filled under a temporary name, so an interrupted run leaves nothing that passes as complete.
    """
    folder = TOOLCHAIN / name
    if is_complete(name, content):
        return folder
    TOOLCHAIN.mkdir(exist_ok=True)
    with only_one_at_a_time():
        if is_complete(name, content):  # another run was faster
            return folder
        partial = Path(tempfile.mkdtemp(prefix=f"partial-{name}-", dir=TOOLCHAIN))
        try:
            partial.chmod(0o755)
            fill(partial)
            (partial / STAMP).write_text(content)
            shutil.rmtree(folder, ignore_errors=True)
            partial.rename(folder)
        finally:
            shutil.rmtree(partial, ignore_errors=True)
    return folder


@contextlib.contextmanager
def only_one_at_a_time():
    """Prevents two runs from fetching the same thing at the same time. Windows has no fcntl, so there is no lock."""
    try:
        import fcntl
    except ImportError:
        yield
        return
    with open(TOOLCHAIN / "lock", "w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        for leftover in TOOLCHAIN.glob("partial-*"):  # of a run that was killed; this run holds the lock
            shutil.rmtree(leftover, ignore_errors=True)
        yield


def environment_with(**changes):
    """The environment with some variables set; a list is put in front of what the variable holds already."""
    result = dict(os.environ)
    for name, value in changes.items():
        if isinstance(value, list):
            value = os.pathsep.join([str(v) for v in value] + ([result[name]] if result.get(name) else []))
        result[name] = str(value)
    return result
