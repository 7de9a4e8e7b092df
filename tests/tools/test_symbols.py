"""The library shows the engine its one entry, and nothing that another library could take for its own."""

import shutil
import subprocess
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


class Symbols(unittest.TestCase):
    @unittest.skipUnless(sys.platform.startswith("linux") and shutil.which("nm"), "nm reads the libraries of Linux")
    def test_the_library_shows_its_entry_only(self):
        for library in (ROOT / "addons/undergrowth/bin").glob("*.template_debug.*.so"):
            shown = subprocess.run(["nm", "-D", "--defined-only", "--format=just-symbols", str(library)],
                                   stdout=subprocess.PIPE, text=True, check=True).stdout.split()
            self.assertEqual(shown, ["undergrowth_init"], library.name)


if __name__ == "__main__":
    unittest.main()
