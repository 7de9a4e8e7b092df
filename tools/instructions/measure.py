"""Runs tests/counts in qemu and makes rows of the instructions that each kernel needs for one plant.

Each kernel runs for processors with SSE2, AVX2 and NEON, compiled by zig as the libraries are shipped. The hashes of what the
kernels write are compared: all processors must give the same bits.
"""

import os
import re
import shlex
import subprocess

from pathlib import Path

from toolchain import emulators, zig
from toolchain.place import Missing, ROOT, say

SOURCE = Path(__file__).parent / "counter.cpp"
BUILD = ROOT / "build/instructions"
FLAGS = ["-std=c++17", "-O2", "-fPIC", "-shared", "-fvisibility=hidden", "-Wall", "-Wextra", "-Werror"]
PLANTS = 4096  # As in tests/counts/kernel_counts.cpp.
TIMES = 4
# {column: (processor, level of the kernels)}
COLUMNS = {"sse2": ("x86_64", "baseline"), "avx2": ("x86_64", "avx2"), "neon": ("arm64", "baseline")}
TIMEOUT = 300  # s


class OtherBits(Exception):
    """Two processors give different bits."""


def rows():
    """The rows of all kernels. Raises Missing where a program cannot be had, and OtherBits."""
    starts = {processor: start_of(processor) for processor in ("x86_64", "arm64")}
    names = call(starts["x86_64"])[0].split()
    return [row_of(name, {column: count(starts[processor], level, name) for column, (processor, level) in COLUMNS.items()})
            for name in names]


def row_of(name, counted):
    """The row of a kernel; `counted`: {column: (hash, instructions per plant)}."""
    hashes = {column: made for column, (made, _) in counted.items()}
    if len(set(hashes.values())) != 1:
        raise OtherBits(f"{name} gives other bits: {hashes}")
    return {"name": name, "plants": PLANTS, "hash": hashes["sse2"],
            **{column: round(number, 2) for column, (_, number) in counted.items()}}


def start_of(processor):
    """Words that start kernel_counts for a processor in qemu, which counts."""
    say(f"Compiling the kernels for {processor}")
    zig.build("linux", processor, "kernel_counts")
    program = ROOT / f"build/obj/core_tests.linux.{processor}/kernel_counts"
    emulator = emulators.fetch(processor)
    return [*emulator.words, "-plugin", str(plugin_for(emulator)), str(program)], emulator.environment


def plugin_for(emulator):
    """Compiles the plugin, whose version is that of the emulator's interface. Returns its path."""
    BUILD.mkdir(parents=True, exist_ok=True)
    library = BUILD / "libcounter.so"
    compiler = shlex.split(os.environ.get("CXX") or "g++")
    words = [*compiler, *FLAGS, f"-DPLUGIN_VERSION={1 if emulator.version < 9 else 2}", str(SOURCE), "-o", str(library)]
    answer = subprocess.run(words, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if answer.returncode != 0:
        raise Missing(f"the plugin of tools/instructions cannot be compiled:\n{answer.stdout}")
    return library


def call(start, *words):
    """(what kernel_counts prints, what the plugin counts)."""
    command, environment = start
    done = subprocess.run([*command, *words], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=TIMEOUT,
                          env=environment)
    numbers = re.findall(r"^(\d+)$", done.stderr, re.MULTILINE)
    if done.returncode != 0 or len(numbers) != 1:
        raise Missing(f"kernel_counts {' '.join(words)} ended with {done.returncode}:\n{done.stderr[-1000:]}")
    return done.stdout.strip(), int(numbers[0])


def count(start, level, name):
    """(hash of what the kernel wrote, its instructions per plant). The difference of two runs has no other instructions."""
    made, once = call(start, level, name, "1")
    again, often = call(start, level, name, str(1 + TIMES))
    if made != again:
        raise OtherBits(f"{name} gives other bits when it runs again")
    return made, (often - once) / (TIMES * PLANTS)
