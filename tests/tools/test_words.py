"""The requirements of each word of ./run."""

import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tools"))

from toolchain import words


class Words(unittest.TestCase):
    def test_targets_are_neither_options_nor_settings(self):
        self.assertEqual(words.targets_of(["-j2", "target=template_release", "build", "test"]), ["build", "test"])

    def test_what_compiles_or_starts_the_engine_needs_godot(self):
        for given in ([], ["build"], ["test"], ["demo", "offscreen=yes"], ["lint", "build"], ["test", "suites=core,engine"],
                      ["test", "suites=fast"]):
            self.assertTrue(words.needs_godot(given), given)

    def test_lint_and_the_suites_of_the_core_do_not(self):
        for given in (["lint"], ["lint", "fix=yes"], ["test", "suites=core,asan"]):
            self.assertFalse(words.needs_godot(given), given)

    @unittest.skipUnless(sys.platform.startswith("linux"), "packages of Debian")
    def test_compilers_of_other_systems_do_not_search_usual_folders(self):
        self.assertTrue(words.ignores_usual_folders(["build", "platform=android", "arch=arm64"]))
        self.assertFalse(words.ignores_usual_folders(["build", "platform=linux"]))


if __name__ == "__main__":
    unittest.main()
