"""The tables of docs/validation.md, which the core's tests fill."""

import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tools"))

import figures  # noqa: E402  (the path above comes first)


class Tables(unittest.TestCase):
    def test_a_table_gets_its_lines_and_nothing_else_changes(self):
        text = "before\n<!-- figures: wind -->\nold\n<!-- end -->\nafter\n"
        lines = [("wind", "gust", "2.12", "1.96"), ("stems", "second", "1", "1")]
        filled = figures.filled(text, lines)
        self.assertEqual(filled, "before\n<!-- figures: wind -->\n| Wind beside measured winds | expected | measured |\n"
                                 "|---|---|---|\n| gust | 2.12 | 1.96 |\n<!-- end -->\nafter\n")
        self.assertEqual(figures.filled(filled, lines), filled)

    def test_validation_has_all_tables_filled(self):
        text = figures.TABLES.read_text(encoding="utf-8")
        found = {name: whole for whole, name in ((match[0], match[2]) for match in figures.TABLE.finditer(text))}
        self.assertEqual(set(found), set(figures.HEADS))
        for name, whole in found.items():
            self.assertGreater(whole.count("\n| "), 3, name)


if __name__ == "__main__":
    unittest.main()
