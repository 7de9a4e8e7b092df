"""One build at a time in a checkout: two that write the same objects would break each other."""

import os
import sys


class BuildLock:
    """Held from its making to `release` or the end of the process. Windows has no fcntl and goes without."""

    def __init__(self, path):
        self.file = None
        try:
            import fcntl
        except ImportError:
            return
        os.makedirs(os.path.dirname(path), exist_ok=True)
        self.file = open(path, "w", encoding="utf-8")
        try:
            fcntl.flock(self.file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            print("Waiting for another build of this checkout to end", file=sys.stderr, flush=True)
            fcntl.flock(self.file, fcntl.LOCK_EX)

    def release(self):
        """Releases the lock before a program starts that may run for long."""
        if self.file:
            self.file.close()
            self.file = None
