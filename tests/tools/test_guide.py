"""The guide's pages: links are valid, scenes draw the pictures, pictures are small, the index lists all pages."""

import re
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
GUIDE = ROOT / "docs/guide"
SCENES = ROOT / "demo_project/guide"
LINK = re.compile(r"\]\(([^)#]+)\)")
CODE = re.compile(r"```.*?```", re.DOTALL)
# Between the parts of a text that a source spells on several lines.
SEAM = re.compile(r'"\s*\+?\s*"')
MAX_BYTES = 1_500_000
MAX_LINES = 130


class Guide(unittest.TestCase):
    pages = sorted(GUIDE.glob("*.md"))

    def test_links_lead_somewhere(self):
        for page in self.pages:
            for target in LINK.findall(CODE.sub("", page.read_text(encoding="utf-8"))):
                if "://" not in target:
                    self.assertTrue((page.parent / target).exists(), f"{page.name}: {target}")

    def test_index_and_readme_name_all_pages(self):
        index = (GUIDE / "README.md").read_text(encoding="utf-8")
        for page in self.pages:
            self.assertTrue(page.name == "README.md" or f"({page.name})" in index, page.name)
        self.assertIn("(docs/guide/README.md)", (ROOT / "README.md").read_text(encoding="utf-8"))

    def test_pages_are_short(self):
        self.assertGreaterEqual(len(self.pages), 10)
        for page in self.pages:
            self.assertLess(len(page.read_text(encoding="utf-8").splitlines()), MAX_LINES, page.name)

    def test_shaders_of_the_scene_wind_are_those_of_its_picture(self):
        page = (GUIDE / "scene_wind.md").read_text(encoding="utf-8")
        shown = re.findall(r"```gdshader\n(.*?)```", page, re.DOTALL)
        drawn = [(SCENES / f"scene_wind_{name}.gdshader").read_text(encoding="utf-8") for name in ("tree", "flag", "smoke")]
        self.assertEqual(shown, drawn)

    def test_each_picture_has_a_scene_and_a_page(self):
        text = "".join(page.read_text(encoding="utf-8") for page in self.pages)
        pictures = {path.stem for path in (GUIDE / "pictures").glob("*.webp")}
        self.assertEqual(pictures, {path.stem for path in SCENES.glob("*.tscn")})
        self.assertEqual(pictures, set(re.findall(r"pictures/(\w+)\.webp", text)))

    def test_messages_in_troubleshooting_are_those_of_the_add_on(self):
        page = (GUIDE / "troubleshooting.md").read_text(encoding="utf-8")
        table = page.partition("| message of the add-on |")[2].partition("\n\n")[0]
        messages = re.findall(r"^\| `([^`]+)` \|", table, re.MULTILINE)
        self.assertGreaterEqual(len(messages), 10)
        sources = "".join(SEAM.sub("", path.read_text(encoding="utf-8")) for folder, kind in
                          (("extension/core", "cpp"), ("extension/godot", "cpp"), ("addons/undergrowth", "gd"))
                          for path in (ROOT / folder).rglob(f"*.{kind}"))
        for message in messages:
            self.assertIn(message, sources)

    def test_pictures_are_small(self):
        size = sum(path.stat().st_size for path in (GUIDE / "pictures").iterdir())
        self.assertLess(size, MAX_BYTES)


if __name__ == "__main__":
    unittest.main()
