"""Windows on x86_64, by wine: the core's tests, and the libraries of the zip open, give their entry and close. Not among
the suites of the plain test: `./run package` first, then `./run test suites=windows`.
"""

import os
import shutil
import subprocess
from pathlib import Path

from shipping import archive, checks
from toolchain import wine, zig
from toolchain.place import Missing

from . import programs, shipped
from .result import LOGS, ROOT, Result, run

FOLDER = LOGS / "windows"
BUILT = ROOT / "build/obj/core_tests.windows.x86_64"
TIMEOUT = 900
OPENED = "opened, entry found, closed"


def suites():
    return [("windows", windows)]


def windows():
    try:
        shutil.rmtree(FOLDER, ignore_errors=True)
        shipped.unpack(FOLDER)
        zig.build("windows", "x86_64", "core_tests")
        folder = wine.fetch()
    except Missing as missing:
        return Result("windows", 0, [str(missing).replace("\n", " ")])
    wine.prepare(folder, FOLDER / "prefix")
    environment = wine.environment(folder, FOLDER / "prefix", os.environ)
    start = wine.program(folder)
    run("windows:boot", [start, "wineboot", "-i"], timeout=TIMEOUT, environment=environment)
    try:
        total = core_tests(start, environment)
        for library in sorted((FOLDER / archive.ADDON / "bin").glob("*.windows.*.x86_64.dll")):
            open_library(total, start, library, environment)
        return total
    finally:
        subprocess.run([wine.server(folder), "-k"], env=environment)


def core_tests(start, environment):
    output, problem = run("windows:core", [start, BUILT / "core_tests.exe", "--no-colors"], timeout=TIMEOUT,
                          environment=environment)
    return programs.read_doctest("windows", output.replace("\r", ""), problem)


def open_library(total, start, library, environment):
    words = [start, BUILT / "open_library.exe", library.name, checks.ENTRY]
    output, problem = run(f"windows:{Path(library.name).stem}", words, timeout=TIMEOUT, folder=library.parent,
                          environment=environment)
    if OPENED in output and not problem:
        total.passed += 1
    else:
        total.failures.append(f"{library.name}: {output.strip() or problem}")
