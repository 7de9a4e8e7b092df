"""Builds for other machines."""

import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))

from building import compiler, doc_data
from shipping import archive


class Building(unittest.TestCase):
    def test_each_listed_library_has_a_compiler_and_both_kinds(self):
        listed = archive.listed((ROOT / archive.LIST).read_text(encoding="utf-8"))
        wanted = {(platform, kind, arch) for platform, arch in compiler.ZIG_TARGETS for kind in ("debug", "release")}
        self.assertEqual(set(listed.values()), wanted)
        for name, (platform, kind, arch) in listed.items():
            suffix = compiler.LIBRARY_SUFFIXES[platform]
            self.assertEqual(name, f"bin/libundergrowth.{platform}.template_{kind}.{arch}{suffix}")

    def test_libraries_for_browsers_are_listed_by_the_names_that_builds_give(self):
        text = (ROOT / archive.LIST).read_text(encoding="utf-8")
        for kind in ("debug", "release"):
            for feature, threads in ((".threads", True), ("", False)):
                suffix = compiler.library_suffix("web", f"template_{kind}", "wasm32", threads)
                self.assertIn(f'web.{kind}{feature}.wasm32 = "bin/libundergrowth.{suffix}.wasm"\n', text)

    def test_help_is_the_same_where_letters_have_no_sign(self):
        self.assertEqual([doc_data.literal(byte) for byte in "aš".encode()], ["97", r"'\xc5'", r"'\xa1'"])


if __name__ == "__main__":
    unittest.main()
