"""The demo as a game."""

import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))

import demo_zip
from shipping import archive


class DemoZip(unittest.TestCase):
    def test_systems_are_those_with_a_release_library(self):
        self.assertEqual(demo_zip.systems_of([]), [])
        self.assertEqual(demo_zip.systems_of([f"{archive.ADDON}/bin/libundergrowth.linux.template_debug.x86_64.so"]), [])
        libraries = [f"{archive.ADDON}/bin/{library}" for _, _, library in demo_zip.SYSTEMS.values()]
        self.assertEqual(demo_zip.systems_of(libraries), ["linux", "windows"])

    def test_its_libraries_are_listed(self):
        listed = archive.listed((ROOT / archive.LIST).read_text(encoding="utf-8"))
        for system, (_, _, library) in demo_zip.SYSTEMS.items():
            self.assertEqual(listed[f"bin/{library}"], (system, "release", "x86_64"))

    def test_each_system_has_a_preset_of_its_number(self):
        text = demo_zip.presets(["linux", "windows"], "/a/template")
        for number, platform in enumerate(("Linux", "Windows Desktop")):
            self.assertIn(f'[preset.{number}]\n\nname="{("linux", "windows")[number]}"\nplatform="{platform}"\n', text)
        self.assertEqual(text.count('custom_template/release="/a/template"'), 2)


if __name__ == "__main__":
    unittest.main()
