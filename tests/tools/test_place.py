"""Folders of the toolchain are created completely or not at all."""

import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tools"))

from toolchain import headers, place


class Folders(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name) / "toolchain"
        patch = mock.patch.object(place, "TOOLCHAIN", self.folder)
        patch.start()
        self.addCleanup(patch.stop)

    def fill(self, folder):
        (folder / "tool").write_text("new")

    def test_is_made_once(self):
        place.make_folder("x", "v1", self.fill)
        made = place.make_folder("x", "v1", lambda folder: self.fail("made twice"))
        self.assertEqual((made / "tool").read_text(), "new")

    def test_another_version_replaces_it(self):
        place.make_folder("x", "v1", lambda folder: (folder / "old").write_text("old"))
        made = place.make_folder("x", "v2", self.fill)
        self.assertFalse((made / "old").exists())

    def test_an_interruption_leaves_nothing(self):
        def interrupted(folder):
            self.fill(folder)
            raise KeyboardInterrupt
        with self.assertRaises(KeyboardInterrupt):
            place.make_folder("x", "v1", interrupted)
        self.assertFalse(place.is_complete("x", "v1"))
        self.assertEqual([path.name for path in self.folder.iterdir()], ["lock"] if (self.folder / "lock").exists() else [])

    def test_leftovers_of_a_killed_run_go(self):
        (self.folder / "partial-x-abc").mkdir(parents=True)
        place.make_folder("x", "v1", self.fill)
        self.assertEqual(list(self.folder.glob("partial-*")), [])


class Headers(unittest.TestCase):
    def test_found_in_a_named_folder(self):
        with tempfile.TemporaryDirectory() as folder:
            header = Path(folder) / "glm/vec3.hpp"
            header.parent.mkdir()
            header.write_text("")
            for variable in headers.FOLDER_VARIABLES:
                self.assertEqual(headers.missing_packages({variable: folder}, usual=()), ["doctest-dev"])

    def test_missing_everywhere(self):
        self.assertEqual(headers.missing_packages({}, usual=()), ["libglm-dev", "doctest-dev"])


if __name__ == "__main__":
    unittest.main()
