"""The contents of the zip."""

import contextlib
import io
import re
import sys
import tempfile
import unittest
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))

import package
from shipping import archive, universal
from small_libraries import elf, macho, pe

ADDON = ROOT / "addons/undergrowth"
LIBRARIES = {"linux.debug.x86_64": ("liba.so", elf()), "linux.release.arm64": ("libb.so", elf(machine=183)),
             "windows.debug.x86_64": ("liba.dll", pe()), "macos.release": ("liba.dylib", universal.join(
                 {"arm64": macho(name="@rpath/liba.dylib"),
                  "x86_64": macho(name="@rpath/liba.dylib", machine=0x01000007, oldest=(10, 15), is_signed=False)}))}
LIST = "[libraries]\n\n" + "".join(f'{key} = "bin/{name}"\n' for key, (name, _) in LIBRARIES.items())


class Package(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.root = Path(scratch.name)
        (self.root / "build").mkdir()
        self.addon = self.root / "addons/undergrowth"
        for name, text in (("plugin.cfg", 'version="9.8.7"\n'), ("undergrowth.gdextension", LIST), ("LICENSE", ""),
                           ("README.md", ""), ("THIRD_PARTY.md", "")):
            self.put(name, text.encode())
        for name, data in LIBRARIES.values():
            self.put("bin/" + name, data)

    def put(self, name, data=b""):
        (self.addon / name).parent.mkdir(parents=True, exist_ok=True)
        (self.addon / name).write_bytes(data)

    def pack(self, is_for_all=True):
        """Returns (errors, output)."""
        with contextlib.redirect_stdout(io.StringIO()) as printed:
            wrong = package.pack(self.root, self.addon / "bin", is_for_all)
        return wrong, printed.getvalue()

    def names(self):
        with zipfile.ZipFile(archive.place(self.root)) as packed:
            return {name[len("addons/undergrowth/"):] for name in packed.namelist()}

    def test_it_is_named_by_the_version_of_the_plugin(self):
        self.assertEqual(self.pack()[0], [])
        self.assertTrue((self.root / "build/undergrowth-9.8.7.zip").exists())

    def test_icons_keep_how_the_editor_draws_them(self):
        self.put("icons/A.svg")
        self.put("icons/A.svg.import")
        self.pack()
        self.assertLessEqual({"icons/A.svg", "icons/A.svg.import"}, self.names())

    def test_what_compilers_and_open_editors_leave_stays_behind(self):
        for name in ("liba.lib", "liba.pdb", "~liba.dll"):
            self.put("bin/" + name)
        self.assertEqual(self.pack()[0], [])
        self.assertEqual({name for name in self.names() if name.startswith("bin/")},
                         {"bin/" + name for name, _ in LIBRARIES.values()})

    def test_equal_files_give_equal_archives(self):
        self.pack()
        first = archive.place(self.root).read_bytes()
        self.pack()
        self.assertEqual(archive.place(self.root).read_bytes(), first)

    def test_libraries_of_macs_are_joined(self):
        parts = {"arm64": macho(), "x86_64": macho(machine=0x01000007)}
        for kind in ("debug", "release"):
            for arch, data in parts.items():
                self.put(f"parts/libundergrowth.macos.template_{kind}.{arch}.dylib", data)
        package.join_parts(self.addon / "parts", self.addon / "bin")
        for kind in ("debug", "release"):
            data = (self.addon / f"bin/libundergrowth.macos.template_{kind}.universal.dylib").read_bytes()
            self.assertEqual(universal.split(data), parts)

    def assert_refused(self, sentence):
        wrong, _ = self.pack()
        self.assertEqual(len(wrong), 1, wrong)
        self.assertRegex(wrong[0], sentence)
        self.assertEqual(list((self.root / "build").iterdir()), [])

    def test_a_missing_library_leaves_no_zip(self):
        self.pack()
        (self.addon / "bin/liba.dll").unlink()
        self.assert_refused("bin/liba.dll is missing")

    def test_neither_does_one_that_nobody_lists(self):
        self.put("bin/libold.so", elf())
        self.assert_refused("bin/libold.so is in the zip, and undergrowth.gdextension does not list it")

    def test_nor_one_with_a_fault(self):
        self.put("bin/libb.so", elf())
        self.assert_refused("bin/libb.so: it is for linux on x86_64")

    def test_nor_one_for_one_of_two_processors(self):
        self.put("bin/liba.dylib", macho(name="@rpath/liba.dylib"))
        self.assert_refused("bin/liba.dylib: it is no universal library")

    def test_nor_one_with_a_path_of_this_folder(self):
        self.put("bin/liba.so", elf(extra=str(self.root).encode() + b"/x.cpp"))
        self.assert_refused("bin/liba.so: it holds a path of the machine that built it")

    def test_nor_missing_notices(self):
        (self.addon / "THIRD_PARTY.md").unlink()
        self.assert_refused("THIRD_PARTY.md is missing")

    def test_half_a_zip_is_told(self):
        self.pack()
        path = archive.place(self.root)
        path.write_bytes(path.read_bytes()[:-100])
        self.assertRegex(archive.complaints(path)[0], "is no whole zip")

    def test_of_this_machine_alone_it_says_when_exported_games_would_find_no_library(self):
        for name in ("libb.so", "liba.dll", "liba.dylib"):
            (self.addon / "bin" / name).unlink()
        self.put("undergrowth.gdextension", b'linux.debug.x86_64 = "bin/lib.template_debug.so"\n')
        (self.addon / "bin/liba.so").rename(self.addon / "bin/lib.template_debug.so")
        wrong, printed = self.pack(is_for_all=False)
        self.assertEqual(wrong, [])
        self.assertIn("without a library for exported games", printed)
        self.assertTrue((self.root / "build/undergrowth-9.8.7-here.zip").exists())


class Version(unittest.TestCase):
    def test_the_changelog_begins_with_that_of_the_plugin(self):
        headings = re.findall(r"^## \[(\S+)\]", (ROOT / "CHANGELOG.md").read_text(encoding="utf-8"), re.MULTILINE)
        self.assertEqual([heading for heading in headings if heading != "Unreleased"][0], archive.version())


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
