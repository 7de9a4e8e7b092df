"""Suites that are programs of their own: doctest's and Python's unittest."""

import os
import re
import shutil
import subprocess
import sys

import figures

from .result import LOGS, Result, run

DOCTEST_TOTAL = re.compile(r"test cases:\s*\d+ \|\s*(\d+) passed \|\s*(\d+) failed")
TIMEOUT = 900  # s: sanitizers take ten times as long, more on a busy machine.
SANITIZER_OPTIONS = {
    "ASAN_OPTIONS": "abort_on_error=1:detect_stack_use_after_return=1",
    "UBSAN_OPTIONS": "print_stacktrace=1:halt_on_error=1:abort_on_error=1",
    "TSAN_OPTIONS": "halt_on_error=1",
}


def without_address_randomisation():
    """Words that start a program at fixed addresses, where the system allows it.

    ThreadSanitizer's shadow memory collides with the wide randomisation of some kernels.
    """
    words = ["setarch", os.uname().machine, "-R"] if shutil.which("setarch") else []
    allowed = words and subprocess.run([*words, "true"], stderr=subprocess.DEVNULL).returncode == 0
    return words if allowed else []


def doctest(name, program):
    """The tests of a doctest program; a sanitizer's report aborts it and is a failure."""
    prefix = without_address_randomisation() if name == "tsan" else []
    figures_file = LOGS / f"{name}_figures.tsv"
    figures_file.unlink(missing_ok=True)
    output, problem = run(name, [*prefix, program, "--no-colors"], timeout=TIMEOUT,
                          environment={**os.environ, **SANITIZER_OPTIONS, "FIGURES": str(figures_file)})
    result = read_doctest(name, output, problem)
    if name == "core" and not result.failures:
        result = check_tables(result, figures_file)
    return result


def check_tables(result, figures_file):
    """Checks that the tables of docs/validation.md contain the measured values."""
    text = figures.TABLES.read_text(encoding="utf-8")
    if figures.filled(text, figures.read(figures_file)) == text:
        return Result(result.name, result.passed + 1, [])
    return Result(result.name, result.passed, ["docs/validation.md is out of date: run ./run figures"])


def read_doctest(name, output, problem):
    """Counts test cases. The name of a failed one is above its first message. Passed ones may print messages too."""
    total = DOCTEST_TOTAL.search(output)
    if not total:
        return Result(name, 0, [f"{problem or 'no summary'}: {first_alarm(output)}"])
    passed, failed = int(total.group(1)), int(total.group(2))
    told = [part.partition("\n")[0].strip() for part in re.split(r"^TEST CASE:", output, flags=re.MULTILINE)[1:]
            if " ERROR: " in part]
    failures = list(dict.fromkeys(told))
    failures = failures[:failed] + ["(see the log)"] * (failed - len(failures))
    if problem and not failures:
        failures = [f"{problem}: {first_alarm(output)}"]
    return Result(name, passed, failures)


def first_alarm(output):
    """Returns the line with the cause of a crash, or the last one."""
    lines = [line.strip() for line in output.splitlines() if line.strip()]
    alarms = [line for line in lines if re.search(r"ERROR: |WARNING: \w+Sanitizer|runtime error:|FATAL", line)]
    return (alarms or lines[-1:] or ["no output"])[0]


def unittest(name, folder):
    """Python's unittest over `folder`."""
    output, problem = run(name, [sys.executable, "-B", "-m", "unittest", "discover", "-v", "-s", folder, "-t", folder])
    failures = re.findall(r"^(?:FAIL|ERROR): (.*)$", output, re.MULTILINE)
    passed = len(re.findall(r"\.\.\. ok$", output, re.MULTILINE))
    if not failures and (problem or not passed):
        failures = [problem or "no tests"]
    return Result(name, passed, failures)
