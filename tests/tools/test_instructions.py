"""The count of instructions: rows of kernels, and an error where processors give different bits."""

import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))

from instructions import measure

SOURCE = (ROOT / "tests/counts/kernel_counts.cpp").read_text(encoding="utf-8")


class Instructions(unittest.TestCase):
    def test_a_row_has_a_number_for_each_processor(self):
        counted = {"sse2": ("a1", 20.517), "avx2": ("a1", 8.3), "neon": ("a1", 17.452)}
        self.assertEqual(measure.row_of("step", counted), {"name": "step", "plants": measure.PLANTS, "hash": "a1",
                                                           "sse2": 20.52, "avx2": 8.3, "neon": 17.45})

    def test_other_bits_are_an_error(self):
        counted = {"sse2": ("a1", 20.5), "avx2": ("a1", 8.3), "neon": ("b2", 17.4)}
        with self.assertRaisesRegex(measure.OtherBits, "step gives other bits"):
            measure.row_of("step", counted)

    def test_both_programs_count_the_same_plants(self):
        self.assertIn(f"constexpr int PLANTS = {measure.PLANTS};", SOURCE)


if __name__ == "__main__":
    unittest.main()
