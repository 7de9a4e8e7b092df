"""What a user unpacks in a project."""

import contextlib
import io
import re
import sys
import tempfile
import unittest
import zipfile
from pathlib import Path
from unittest import mock

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))

import package

ADDON = ROOT / "addons/undergrowth"


class Package(unittest.TestCase):
    def pack(self, *names):
        """The archive's bytes and what is printed, for an add-on of files with these names."""
        with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stdout(io.StringIO()) as printed:
            root = Path(folder)
            (root / "build").mkdir()
            for name in names:
                path = root / "addons/undergrowth" / name
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(name)
            with mock.patch.multiple(package, ROOT=root, ADDON=root / "addons/undergrowth"):
                self.assertEqual(package.main(), 0)
            return (root / "build/undergrowth.zip").read_bytes(), printed.getvalue()

    def names(self, *names):
        with zipfile.ZipFile(io.BytesIO(self.pack(*names)[0])) as archive:
            return [name[len("addons/undergrowth/"):] for name in archive.namelist()]

    def test_icons_keep_how_the_editor_draws_them(self):
        self.assertEqual(self.names("icons/A.svg", "icons/A.svg.import"), ["icons/A.svg", "icons/A.svg.import"])

    def test_what_compilers_and_open_editors_leave_stays_behind(self):
        self.assertEqual(self.names("bin/liba.dll", "bin/liba.lib", "bin/liba.pdb", "bin/~liba.dll"), ["bin/liba.dll"])

    def test_equal_files_give_equal_archives(self):
        self.assertEqual(self.pack("plugin.cfg", "bin/a.so")[0], self.pack("plugin.cfg", "bin/a.so")[0])

    def test_it_says_when_exported_games_would_find_no_library(self):
        self.assertIn("without a library for exported games", self.pack("bin/lib.linux.template_debug.so")[1])
        self.assertNotIn("without", self.pack("bin/lib.linux.template_release.so")[1])


class Classes(unittest.TestCase):
    def test_each_has_an_icon(self):
        listed = dict(re.findall(r'^(\w+) = "(icons/\S+)"$', (ADDON / "undergrowth.gdextension").read_text(), re.MULTILINE))
        documented = {path.stem for path in (ROOT / "extension/doc_classes").glob("*.xml")}
        self.assertEqual(set(listed), documented)
        for path in listed.values():
            self.assertTrue((ADDON / path).is_file(), path)
            self.assertTrue((ADDON / (path + ".import")).is_file(), path)


if __name__ == "__main__":
    unittest.main()
