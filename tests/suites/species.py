"""Species of random numbers grown, measured, planned, drawn and bent under AddressSanitizer and UBSan (tests/species). Not
among the suites of the plain test: `./run test suites=species`.

SPECIES_COUNT says how many (2000; a processor of its own tries about 180 a second), SPECIES_SEED with which seed they
begin (0). A seed that fails is told; SPECIES_SEED=it SPECIES_COUNT=1 tries it alone. Each processor has its share of the
seeds. How far each is stands in build/test/species-N.log.
"""

import os
import re

from .programs import SANITIZER_OPTIONS
from .result import Result, run

COUNT = 2000
LONGEST = 7 * 24 * 3600  # s. Slow species end by a limit of the program.
SILENCE = 120  # s. The program reports a species after 30 s.
MAX_ENDS = 5  # Aborts of one share by sanitizers. More end the share.
FAILED_LINE = re.compile(r"^FAILED (seed (\d+): .*)$", re.MULTILINE)
END_LINE = re.compile(r"^done: (\d+) species, (\d+) grown, (\d+) failed, (slowest \d+ with \d+ ms)$", re.MULTILINE)


def suites(program):
    """A share of the seeds for each processor."""
    count = int(os.environ.get("SPECIES_COUNT", COUNT))
    first = int(os.environ.get("SPECIES_SEED", "0"))
    step = max(1, min(os.cpu_count() or 1, count))
    shares = [(first + i, (count - i + step - 1) // step) for i in range(step)]
    return [(f"species:{i}", lambda i=i, share=share: grow(f"species:{i}", program, *share, step))
            for i, share in enumerate(shares)]


def grow(name, program, first, count, step):
    """Counts each species as a test. If one ends the program, another program continues."""
    total = Result(name)
    ends = 0
    while count > 0:
        log = f"{name}:{ends}" if ends else name
        output, problem = run(log, [program, first, count, step], LONGEST, silence=SILENCE,
                              environment={**os.environ, **SANITIZER_OPTIONS})
        read = read_output(name, output, problem, first, step)
        total.passed += read.passed
        total.failures += read.failures
        total.notes += read.notes
        seeds = [int(seed) for _, seed in FAILED_LINE.findall(output)]
        ends += 1
        if END_LINE.search(output) or not seeds or ends == MAX_ENDS:
            break
        done = (seeds[-1] - first) // step + 1
        first, count = first + done * step, count - done
    return total


def read_output(name, output, problem, first=0, step=1):
    """Counts the seeds of an aborted program: all before the last seed that it printed."""
    failed = FAILED_LINE.findall(output)
    failures = [failure for failure, _ in failed]
    end = END_LINE.search(output)
    if end:
        notes = [f"{end.group(1)} species, {end.group(2)} of them grew, {end.group(4)}"]
        if problem and not failures:
            failures = [problem]
        return Result(name, int(end.group(1)) - len(failed), failures, notes)
    tried = (int(failed[-1][1]) - first) // step + 1 if failed else 0
    return Result(name, max(0, tried - len(failed)), failures or [f"ended early: {problem or 'no last line'}"])
