"""Linux on arm64, by qemu: the core's tests, and some of the engine's with the library of the zip in Debian's Godot for
that processor. A plain test does not run it: `./run package` first, then `./run test suites=arm64`.

`./run test suites=kernels` needs no package: it compares the bits that the kernels write on three processors, and limits the
instructions of those for NEON.
"""

import shlex

from instructions import measure
from shipping import archive
from toolchain import arm64, zig
from toolchain.place import Missing

from . import engine, programs, shipped
from .result import LOGS, ROOT, Result, run

FOLDER = LOGS / "arm64"
CORE_TESTS = ROOT / "build/obj/core_tests.linux.arm64/core_tests"
# One script per area: growth, wind, motion, fields, and the help, because `char` is unsigned on arm64.
SCRIPTS = ("plant_function", "motion", "simulation", "field", "class_help")
TIMEOUT = 1800
# Both have vectors of four floats. A kernel for NEON that is compiled to single floats has twice the instructions.
MAX_OVER_SSE2 = 1.35


def suites():
    return [("arm64", run_all), ("kernels", compare_kernels)]


def compare_kernels():
    try:
        rows = measure.rows()
    except (Missing, measure.OtherBits) as problem:
        return Result("kernels", 0, [str(problem).replace("\n", " ")])
    long = [f"{row['name']} takes {row['neon']} instructions with NEON, {row['sse2']} with SSE2" for row in rows
            if row["neon"] > MAX_OVER_SSE2 * row["sse2"]]
    return Result("kernels", len(rows) - len(long), long)


def run_all():
    try:
        project = shipped.make_test_project(FOLDER / "project")
        if not list((project / archive.ADDON / "bin").glob("*.linux.template_debug.arm64.so")):
            raise Missing(f"{shipped.newest_zip().name} has no library for arm64: say `./run package` first")
        zig.build("linux", "arm64", "core_tests")
        emulator, folder = arm64.fetch()
    except Missing as missing:
        return Result("arm64", 0, [str(missing).replace("\n", " ")])
    total = programs.read_doctest("arm64", *run("arm64:core", [*emulator, CORE_TESTS, "--no-colors"], timeout=TIMEOUT))
    for name in SCRIPTS:
        part = run_script(write_starter(emulator, folder), project, name)
        total.passed += part.passed
        total.failures += [f"{name}: {failure}" for failure in part.failures]
    return total


def write_starter(emulator, folder):
    """Returns a script that starts Godot for arm64, for tests that start another engine."""
    starter = FOLDER / "godot"
    words = " ".join(map(shlex.quote, [*emulator, str(folder / "usr/bin/godot")]))
    starter.write_text(f'#!/bin/sh\nexec {words} "$@"\n')
    starter.chmod(0o755)
    return starter


def run_script(godot, project, name):
    words = [godot, "--headless", "--path", project, *engine.STEADY, "--script", f"res://tests/engine/test_{name}.gd"]
    environment = {**engine.private_home(), "GODOT": str(godot)}
    return engine.read_output(f"arm64:{name}", *run(f"arm64:{name}", words, timeout=TIMEOUT, environment=environment))
