"""The store kit: its pictures exist, are small and have the store's shape; its texts match the add-on."""

import struct
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))

import store

MAX_BYTES = 1_500_000  # Of all pictures.
START_OF_FRAME = {0xC0, 0xC1, 0xC2}


def jpeg_size(path):
    """(width, height) of a JPEG, from its first frame header."""
    data = path.read_bytes()
    at = 2
    while data[at + 1] not in START_OF_FRAME:
        at += 2 + struct.unpack(">H", data[at + 2:at + 4])[0]
    height, width = struct.unpack(">HH", data[at + 5:at + 9])
    return width, height


class Store(unittest.TestCase):
    text = (store.STORE / "README.md").read_text(encoding="utf-8")
    names = [*store.VIEWS.values(), *store.SHIPPED.values()]

    def test_pictures_have_the_stores_shape(self):
        for name in self.names:
            self.assertEqual(jpeg_size(store.STORE / f"{name}.jpg"), store.SIZE, name)
        self.assertEqual(jpeg_size(store.STORE / "thumbnail.jpg"), (store.THUMBNAIL, store.THUMBNAIL))

    def test_pictures_are_small_and_named_in_the_text(self):
        pictures = list(store.STORE.glob("*.jpg"))
        self.assertEqual({path.stem for path in pictures}, {*self.names, "thumbnail"})
        self.assertLess(sum(path.stat().st_size for path in pictures), MAX_BYTES)
        for path in pictures:
            self.assertIn(f"`{path.name}`", self.text)

    def test_the_engine_does_not_import_them(self):
        self.assertTrue((store.STORE / ".gdignore").exists())

    def test_the_use_of_ai_is_disclosed(self):
        self.assertIn("## Use of AI", self.text)

    def test_figures_are_those_of_readme(self):
        readme = (ROOT / "README.md").read_text(encoding="utf-8")
        self.assertIn("| 97,179 | 95 + 64 |", readme)
        self.assertIn("97,179 plants of eleven species take 95 draw calls", self.text)

    def test_numbers_of_species_and_mixes_are_those_shipped(self):
        mixes = list((ROOT / "addons/undergrowth/mixes").glob("*.tscn"))
        self.assertEqual(len(mixes), 5)
        self.assertIn("Twenty-nine species and five mixes", self.text)


if __name__ == "__main__":
    unittest.main()
