"""Versions as programs print them."""

import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tools"))

from toolchain import godot, python_tools


class Versions(unittest.TestCase):
    def test_godot_stable(self):
        self.assertEqual(godot.parse_version("4.6.3.stable.official.abcdef\n"), (4, 6))

    def test_godot_after_a_warning(self):
        self.assertEqual(godot.parse_version("WARNING: no audio\n4.10.stable.debian4.10+ds-2\n"), (4, 10))

    def test_godot_compares_by_number(self):
        self.assertGreater(godot.parse_version("4.10.stable"), godot.OLDEST)
        self.assertLess(godot.parse_version("3.6.1.stable"), godot.OLDEST)

    def test_godot_of_something_else_is_none(self):
        self.assertIsNone(godot.parse_version("bash: godot: not found\n"))

    def test_scons(self):
        text = "SCons by Steven Knight et al.:\n\tSCons: v4.11.1.deadbeef, Thu, 01 Jan 2026\n"
        self.assertEqual(python_tools.scons_version(text), (4, 11))
        self.assertIsNone(python_tools.scons_version("no such program"))


if __name__ == "__main__":
    unittest.main()
