"""Reading and judging pictures, on pictures made here."""

import struct
import sys
import tempfile
import unittest
import zlib
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tools"), str(ROOT / "tests")]

from suites import picture

GREEN, BLUE, GREY = (60, 140, 40), (120, 160, 220), (128, 128, 128)


def frame(*colours, width=30):
    """A picture of three equal bands of colour, as read_png gives it."""
    rows = [bytes(colour) * width for colour in colours for _ in range(10)]
    return width, len(rows), rows, 3


class Judging(unittest.TestCase):
    meadow = frame(BLUE, GREEN, GREEN)
    swayed = frame(BLUE, GREEN, (90, 180, 60))

    def test_a_meadow_that_sways_passes(self):
        self.assertEqual(picture.complaints(self.meadow, self.swayed), [])

    def test_each_lack_is_named(self):
        for first, last, lack in ((self.meadow, self.meadow, "moved"), (frame(BLUE, GREY, GREY), self.swayed, "plants"),
                                  (frame(GREEN, GREEN, GREEN), self.swayed, "sky")):
            wrong = picture.complaints(first, last)
            self.assertEqual(len(wrong), 1, wrong)
            self.assertIn(lack, wrong[0])


class Reading(unittest.TestCase):
    def chunk(self, kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    def test_every_filter(self):
        # Two pixels a line; worked out by hand from the specification.
        lines = [(0, [10, 20, 30, 40, 50, 60]), (1, [1, 2, 3, 4, 5, 6]), (2, [1] * 6), (3, [2] * 6), (4, [3] * 6)]
        packed = zlib.compress(b"".join(bytes([kind, *values]) for kind, values in lines))
        header = struct.pack(">IIBBBBB", 2, 5, 8, 2, 0, 0, 0)
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "x.png"
            path.write_bytes(b"\x89PNG\r\n\x1a\n" + self.chunk(b"IHDR", header) + self.chunk(b"IDAT", packed[:9]) +
                             self.chunk(b"IDAT", packed[9:]) + self.chunk(b"IEND", b""))
            width, height, rows, pixel = picture.read_png(path)
            self.assertEqual((width, height, pixel), (2, 5, 3))
            self.assertEqual(picture.read_size(path), (2, 5))
        self.assertEqual([list(row) for row in rows], [
            [10, 20, 30, 40, 50, 60],
            [1, 2, 3, 5, 7, 9],
            [2, 3, 4, 6, 8, 10],
            [3, 3, 4, 6, 7, 9],
            [6, 6, 7, 9, 10, 12],
        ])


if __name__ == "__main__":
    unittest.main()
