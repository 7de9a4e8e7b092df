"""What a suite returns, and running a program so that nothing it does goes unnoticed."""

import dataclasses
import os
import signal
import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
LOGS = ROOT / "build/test"


@dataclasses.dataclass
class Result:
    """The number of tests that passed, and one line for each that failed."""

    name: str
    passed: int = 0
    failures: list = dataclasses.field(default_factory=list)


def run(name, command, timeout=300, folder=ROOT, environment=None):
    """Runs `command` with its output in build/test/<name>.log. Returns (output, what went wrong or None)."""
    log = LOGS / (name.replace(":", "-").replace("/", "-") + ".log")
    with open(log, "wb") as out:
        try:
            process = subprocess.Popen([str(word) for word in command], cwd=folder, stdout=out, stdin=subprocess.DEVNULL,
                                       stderr=subprocess.STDOUT, env=environment, start_new_session=True)
        except OSError as error:
            return "", f"did not start: {error}"
        try:
            status = process.wait(timeout)
        except subprocess.TimeoutExpired:
            status = None
            kill_group(process)
    return log.read_text(errors="replace"), complaint(status, timeout)


def kill_group(process):
    """Ends the process and what it started: the session that `run` gave it."""
    if os.name == "posix":
        os.killpg(process.pid, signal.SIGKILL)
    else:
        process.kill()
    process.wait()


def complaint(status, timeout):
    if status is None:
        return f"not done after {timeout} s"
    if status < 0:
        return f"crashed with {signal.Signals(-status).name}"
    return f"exit status {status}" if status else None
