"""The libraries that were built here export their entry function only, so that no symbol
collides with those of another library."""

import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))

from shipping import archive, checks, universal


class Symbols(unittest.TestCase):
    def test_the_libraries_show_their_entry_only(self):
        for name in archive.listed((ROOT / archive.LIST).read_text(encoding="utf-8")):
            path = ROOT / archive.ADDON / name
            for data in universal.each(path.read_bytes()) if path.exists() else []:
                self.assertEqual(checks.wrong_exports(checks.read(data)), [], name)


if __name__ == "__main__":
    unittest.main()
