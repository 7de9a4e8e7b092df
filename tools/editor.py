#!/usr/bin/env python3
"""Opens the demo project in the editor and waits until it is closed."""

import argparse
import subprocess
import sys
from pathlib import Path

from toolchain import display

ROOT = Path(__file__).resolve().parents[1]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--godot", required=True)
    godot = parser.parse_args().godot
    if not display.has_display():
        print("There is no display for the editor. `./run demo offscreen=yes` draws the demo without one.")
        return 1
    return subprocess.run([godot, "--path", str(ROOT / "demo_project"), "--editor"]).returncode


if __name__ == "__main__":
    sys.exit(main())
