"""The result of a suite, and a runner that detects every failure of a program."""

import dataclasses
import os
import signal
import subprocess
import threading
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
LOGS = ROOT / "build/test"
POLL = 0.05  # s
_used = threading.local()


@dataclasses.dataclass
class Result:
    """The number of passed tests, one line per failed test, lines to print in any case, and seconds of a processor."""

    name: str
    passed: int = 0
    failures: list = dataclasses.field(default_factory=list)
    notes: list = dataclasses.field(default_factory=list)
    seconds: float = 0.0


def run(name, command, timeout=300, folder=ROOT, environment=None, silence=None):
    """Runs `command` with its output in build/test/<name>.log. Returns (output, error or None). Ends it
    after `timeout` seconds, or after `silence` seconds without output."""
    log = LOGS / (name.replace(":", "-").replace("/", "-") + ".log")
    with open(log, "wb") as out:
        try:
            process = subprocess.Popen([str(word) for word in command], cwd=folder, stdout=out, stdin=subprocess.DEVNULL,
                                       stderr=subprocess.STDOUT, env=environment, start_new_session=True)
        except OSError as error:
            return "", f"did not start: {error}"
        problem = wait(process, log, timeout, silence)
    return log.read_text(errors="replace"), problem


def processor_time():
    """Returns the seconds on processors of all programs that this thread has run, with their ended children."""
    return getattr(_used, "seconds", 0.0)


def wait(process, log, timeout, silence):
    """Returns the error of the process at its end, or None."""
    end = time.monotonic() + timeout
    size, spoken = 0, time.monotonic()
    while not has_ended(process):
        now = time.monotonic()
        if log.stat().st_size != size:
            size, spoken = log.stat().st_size, now
        if silence and now - spoken > silence:
            problem = f"silent for {silence} s"
        elif now >= end:
            problem = f"not done after {timeout} s"
        else:
            time.sleep(POLL)
            continue
        kill_group(process)
        return problem
    return complaint(process.returncode)


def has_ended(process):
    """True if the process has ended. Its processor time then counts for this thread."""
    if os.name != "posix":
        return process.poll() is not None
    pid, status, usage = os.wait4(process.pid, os.WNOHANG)
    if pid == 0:
        return False
    process.returncode = os.waitstatus_to_exitcode(status)
    _used.seconds = processor_time() + usage.ru_utime + usage.ru_stime
    return True


def kill_group(process):
    """Ends the process and its children: the session that `run` created."""
    if os.name == "posix":
        os.killpg(process.pid, signal.SIGKILL)
    else:
        process.kill()
    process.wait()


def complaint(status):
    if status < 0:
        return f"crashed with {signal.Signals(-status).name}"
    return f"exit status {status}" if status else None
