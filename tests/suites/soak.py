"""Fields and plants used at random for minutes, headless and drawn, with the add-on's library under AddressSanitizer and
UBSan (tests/engine/soak). Not among the suites of the plain test: `./run test suites=soak`.

SOAK_SECONDS is the duration of each of the two runs (600), SOAK_SEED their first seed (by default from the clock).
"""

import os
import re
import shutil
import subprocess
import time
from pathlib import Path

from building import project
from toolchain import display
from toolchain.place import Missing

from .engine import PROJECT, private_home
from .result import LOGS, ROOT, Result, run

METHODS = {"headless": None, "drawn": "gl_compatibility"}
SCRIPT = "res://tests/engine/soak/soak.gd"
# Seconds: what a start, an end and one round more may take under sanitizers on a busy machine, and how long a run may
# say nothing.
MARGIN, SILENCE = 600, 240
# Drivers free some memory by another way than they got it; what leaks is looked at below; and what is preloaded comes
# before the sanitizer's library, on purpose.
OPTIONS = {
    "ASAN_OPTIONS": "detect_leaks=1:alloc_dealloc_mismatch=0:verify_asan_link_order=0:detect_stack_use_after_return=1:"
                    "quarantine_size_mb=64:allocator_may_return_null=1:fast_unwind_on_malloc=1:malloc_context_size=16",
    "LSAN_OPTIONS": "exitcode=0:max_leaks=0:print_suppressions=0",
    "UBSAN_OPTIONS": "print_stacktrace=1:halt_on_error=1",
}
REPORT = re.compile(r"ERROR: AddressSanitizer|runtime error:|ERROR: UndefinedBehaviorSanitizer|SCRIPT ERROR|Parse Error")
LEAK = re.compile(r"^(?:Direct|Indirect) leak of (\d+) byte.*?(?=^\s*$)", re.MULTILINE | re.DOTALL)
END_LINE = re.compile(r"^done: (\d+) rounds, (\d+) actions$", re.MULTILINE)
ROUND_LINE = re.compile(r"^round \d+ seed (\d+)$", re.MULTILINE)


def suites(godot, folder):
    """A run headless and one drawn, with the library in `folder`."""
    return [(f"soak:{name}", lambda name=name: soak(godot, Path(folder), name)) for name in METHODS]


def make_project(folder, name):
    """A project with a copy of the add-on that has the library from `folder`."""
    place = LOGS / f"project_soak_{name}"
    shutil.rmtree(place, ignore_errors=True)
    shutil.copytree(ROOT / "addons", place / "addons", ignore=shutil.ignore_patterns("bin"))
    project.link(folder, place / "addons/undergrowth/bin")
    (place / "project.godot").write_text(PROJECT)
    project.list_extensions(place)
    project.list_uids(place)
    (place / "tests").mkdir()
    project.link(ROOT / "tests/engine", place / "tests/engine")
    return place


def runtimes(folder):
    """The sanitizers' libraries that the add-on's was linked with."""
    library = next(path for path in folder.glob("libundergrowth.*"))
    lines = subprocess.run(["ldd", library], text=True, stdout=subprocess.PIPE, check=True).stdout
    return re.findall(r"=> (\S*lib(?:asan|ubsan)\S*)", lines)


def preloaded(folder, environment):
    """`environment` in which an engine can open the library in `folder`."""
    words = [str(folder / "libshallow.so"), *runtimes(folder)]
    return {**environment, **OPTIONS, "LD_PRELOAD": ":".join(words)}


def soak(godot, folder, name):
    seconds = int(os.environ.get("SOAK_SECONDS", "600"))
    seed = int(os.environ.get("SOAK_SEED", str(time.time_ns() % 1000000007)))
    # The engine's crash handler reports less.
    words = [godot, "--path", make_project(folder, name), "--script", SCRIPT, "--disable-crash-handler"]
    method = METHODS[name]
    words += ["--rendering-method", method, "--audio-driver", "Dummy"] if method else ["--headless"]
    words += ["--", f"--seconds={seconds}", f"--seed={seed}"]
    try:
        if not method:
            return start(name, words, preloaded(folder, private_home()), seconds)
        with display.virtual(640, 360) as environment:
            return start(name, words, preloaded(folder, private_home(environment)), seconds)
    except Missing as missing:
        return Result(f"soak:{name}", 0, [str(missing).replace("\n", " ")])


def start(name, words, environment, seconds):
    # By `env`, so that the preload affects only the engine.
    words = ["env", f"LD_PRELOAD={environment.pop('LD_PRELOAD')}", *words]
    return read_output(f"soak:{name}", *run(f"soak:{name}", words, timeout=seconds + MARGIN, environment=environment,
                                            silence=SILENCE))


def read_output(name, output, problem):
    """Counts each round as a test. Sanitizer reports, script errors, crashes and the add-on's leaks fail."""
    seeds, end = ROUND_LINE.findall(output), END_LINE.search(output)
    last = f"in the round with seed {seeds[-1]}" if seeds else "before the first round"
    failures = [f"{line.strip()} ({last})" for line in output.splitlines() if REPORT.search(line)][:5]
    if not end or not int(end.group(1)):
        failures.append(f"ended early: {problem or 'no last line'} ({last})")
    elif problem and not failures:
        failures.append(problem)
    return Result(name, int(end.group(1)) if end else max(0, len(seeds) - 1), failures + own_leaks(output))


def own_leaks(output):
    """Returns one line per leak with the add-on's library in its stack. The engine and drivers leak too."""
    leaks = [leak.group(0) for leak in LEAK.finditer(output)]
    ours = [leak for leak in leaks if "libundergrowth" in leak]
    return [" ".join(leak.split())[:300] for leak in ours]
