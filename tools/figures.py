#!/usr/bin/env python3
"""Writes what the core's tests measure into the tables of docs/validation.md, between <!-- figures: NAME --> and <!-- end -->."""

import argparse
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
TABLES = ROOT / "docs/validation.md"
TABLE = re.compile(r"(<!-- figures: (\w+) -->\n).*?(<!-- end -->)", re.DOTALL)
HEADS = {"stems": "Stems beside beams and chains", "swings": "Stems that swing, beside chains",
         "wind": "Wind beside measured winds"}
TIMEOUT = 900


def read(path):
    """The lines of the tests' output: table, quantity, expected, measured."""
    return [tuple(line.split("\t")) for line in Path(path).read_text(encoding="utf-8").splitlines()]


def table(name, lines):
    rows = [f"| {HEADS[name]} | expected | measured |", "|---|---|---|"]
    rows += [f"| {what} | {asked} | {measured} |" for of, what, asked, measured in lines if of == name]
    return "\n".join(rows) + "\n"


def filled(text, lines):
    """`text` with its tables replaced by `lines`."""
    return TABLE.sub(lambda found: found[1] + table(found[2], lines) + found[3], text)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--core", required=True, help="the program of the core's tests")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "figures.tsv"
        words = [options.core, "--no-colors", "--minimal"]
        answer = subprocess.run(words, env={**os.environ, "FIGURES": str(path)}, timeout=TIMEOUT)
        if answer.returncode != 0 or not path.exists():
            sys.exit("The core's tests fail, so docs/validation.md keeps its figures: see ./run test suites=core")
        lines = read(path)
    before = TABLES.read_text(encoding="utf-8")
    after = filled(before, lines)
    TABLES.write_text(after, encoding="utf-8")
    print("docs/validation.md is up to date" + (" (no change)" if after == before else ""))
    return 0


if __name__ == "__main__":
    sys.exit(main())
