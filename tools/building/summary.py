"""The last line of `scons test`: how many tests passed and failed, after everything that SCons itself says."""

import atexit
import os


def print_at_exit(path):
    """Prints the line that the tests leave at `path`; one failure if a failed build prevented them from running."""
    if os.path.exists(path):
        os.remove(path)

    def finish():
        line = "0 passed, 1 failed"
        if os.path.exists(path):
            with open(path, encoding="utf-8") as summary:
                line = summary.read().strip()
        print(line, flush=True)

    atexit.register(finish)
