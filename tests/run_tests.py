#!/usr/bin/env python3
"""Runs the test suites at the same time, prints what failed, and ends with one line `N passed, N failed`.

SConstruct builds the programs and calls this (`scons test`). Each suite's output goes to build/test/<suite>.log. A crash,
a timeout, a program that prints nothing and an engine that complains while it shuts down count as failures. The suites
`soak`, `species`, `kernels` (bits and instructions on three processors), `syntax` (sources for phones and browsers) and
`single` (the engine's headless ones without worker threads), and those on the zip, `package`, `export`, `windows` and `arm64`,
run only by name.
The target is 8 minutes on two quiet cores, 960 s of a processor, once all is built and the caches of shaders below
build/test are filled. The line before the last one says how many seconds it took.
`fast` names the core's suite and the engine's headless ones: at most 4 minutes on two quiet cores.
"""

import argparse
import concurrent.futures
import os
import random
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path[:0] = [str(ROOT / "tools"), str(ROOT / "tests")]

from suites import arm64, bench_scene, editor, engine, export, package, picture, programs, soak, species, syntax, windows  # noqa: E402  (the path above comes first)
from suites.result import processor_time  # noqa: E402

LOGS = ROOT / "build/test"


def plan(options):
    """The suites as (name, function that runs it and returns a Result)."""
    # The longest first.
    suites = []
    if options.godot:
        suites += [("picture", lambda: picture.demo(options.godot)), ("editor", lambda: editor.run(options.godot, options.only)),
                   ("bench_scene", lambda: bench_scene.run(options.godot))]
    suites += [("tools", lambda: programs.unittest("tools", ROOT / "tests/tools"))]
    for name, program in (("core", options.core), ("asan", options.asan), ("tsan", options.tsan)):
        if program:
            suites.append((name, lambda name=name, program=program: programs.doctest(name, program)))
    suites += species.suites(options.species) if options.species else []
    if options.godot:
        suites += engine.suites(options.godot, options.probe, options.recorder, rounds_of(options), options.only)
        suites += soak.suites(options.godot, options.soak) if options.soak else []
    chosen = set(options.suites.split(",")) if options.suites else None
    suites += engine.without_workers(options.godot, options.only) if options.godot and chosen and "single" in chosen else []
    suites += of_what_is_shipped(options) if chosen else []
    return [(name, run) for name, run in suites if is_chosen(name, chosen)]


def is_chosen(name, chosen):
    """True if the suite is among the named ones, or if none are named."""
    kind = name.split(":")[0]
    return not chosen or kind in chosen or ("fast" in chosen and is_fast(name))


def is_fast(name):
    """The suites for each change: the core's, and those of the engine that need no display."""
    return name == "core" or (name.startswith("engine:") and engine.is_headless(name))


def of_what_is_shipped(options):
    """Suites on the zip and for other systems, which take long and fetch much: only where they are named."""
    suites = windows.suites() + arm64.suites() + syntax.suites(options.only)
    return suites + (package.suites(options.godot) + export.suites(options.godot) if options.godot else [])


def rounds_of(options):
    """Describes rounds and order of the engine suites, so that they can be repeated."""
    if options.order == "written":
        return engine.Rounds(options.times)
    seed = random.randrange(1000000) if options.seed is None else options.seed
    print(f"Engine suites in random order: order=random seed={seed} times={options.times}", flush=True)
    return engine.Rounds(options.times, seed)


def run_all(suites, jobs):
    """Returns the results in the order of `suites` and prints each at its end."""
    def timed(name, run):
        start, before = time.monotonic(), processor_time()
        result = run()
        result.seconds = processor_time() - before
        print(f"{name:<32}{result.passed:>5} passed {len(result.failures):>3} failed {time.monotonic() - start:>7.1f} s, "
              f"{result.seconds:>7.1f} s of a processor", flush=True)
        return result

    with concurrent.futures.ThreadPoolExecutor(max_workers=jobs) as pool:
        waiting = [pool.submit(timed, name, run) for name, run in suites]
        return [one.result() for one in waiting]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    for name in ("godot", "core", "asan", "tsan", "species", "probe", "recorder"):
        parser.add_argument(f"--{name}", help=f"the program for {name}; without it those suites are left out")
    parser.add_argument("--soak", help="the folder of the library with sanitizers; without it the soak is left out")
    parser.add_argument("--suites", help="only these, separated by commas")
    parser.add_argument("--only", help="of the engine's and the editor's suites only these, separated by commas: field_*,motion")
    parser.add_argument("--times", type=int, default=1, help="how often each engine suite runs")
    parser.add_argument("--order", choices=["written", "random"], default="written", help="of an engine suite's tests")
    parser.add_argument("--seed", type=int, help="of the random order; by chance where it is left out")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    parser.add_argument("--summary", type=Path, help="write the last line there instead of printing it")
    options = parser.parse_args()

    LOGS.mkdir(parents=True, exist_ok=True)
    results = run_all(plan(options), options.jobs)
    failures = [(result.name, failure) for result in results for failure in result.failures]
    for name, failure in failures:
        print(f"FAILED {name}: {failure}")
    for result in results:
        for note in result.notes:
            print(f"NOTE {result.name}: {note}")
    if failures:
        print(f"The suites' output is in {LOGS.relative_to(ROOT)}/<suite>.log")
    print(f"{sum(result.seconds for result in results):.0f} s of a processor in all")
    line = f"{sum(result.passed for result in results)} passed, {len(failures)} failed"
    if options.summary:
        options.summary.write_text(line + "\n")
    else:
        print(line)
    return 1 if failures or not results else 0


if __name__ == "__main__":
    sys.exit(main())
