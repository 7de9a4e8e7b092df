"""Builds for other machines."""

import sys
import unittest
import unittest.mock
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))

from building import compiler, doc_data
from shipping import archive


class Building(unittest.TestCase):
    def test_each_listed_library_has_a_compiler_and_both_kinds(self):
        listed = archive.listed((ROOT / archive.LIST).read_text(encoding="utf-8"))
        wanted = {(platform, kind, "universal" if platform == "macos" else arch)
                  for platform, arch in compiler.ZIG_TARGETS for kind in ("debug", "release")}
        self.assertEqual(set(listed.values()), wanted)
        for name, (platform, kind, arch) in listed.items():
            self.assertEqual(name, "bin/" + compiler.library_name(platform, f"template_{kind}", arch))

    def test_a_mac_builds_the_library_that_is_listed(self):
        with unittest.mock.patch("sys.platform", "darwin"):
            self.assertEqual(compiler.host_architecture(), "universal")

    def test_parts_for_macs_are_called_as_the_library_of_both(self):
        for arch in compiler.MAC_PROCESSORS:
            name = compiler.library_name("macos", "template_debug", arch)
            self.assertEqual(compiler.of_both(name), "libundergrowth.macos.template_debug.universal.dylib")

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
