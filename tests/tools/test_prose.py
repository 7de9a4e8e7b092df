"""The language check of ./run lint."""

import contextlib
import io
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tools"))

import prose  # noqa: E402  (the path above comes first)


class Words(unittest.TestCase):
    def test_only_comments_of_a_source_count(self):
        text = 'int nobody = 1; // Whoever asks.\n/* A tile\n that stands. */\nsay("who");\n'
        self.assertEqual(prose.rate([prose.prose(Path("a.cpp"), text)]), (6, 500.0))

    def test_comments_and_docstrings_of_a_script_count(self):
        text = 'var told := 1\n## Returns the tile.\n# Nobody.\n'
        self.assertEqual(prose.rate([prose.prose(Path("a.gd"), text)]), (4, 250.0))
        self.assertIn("whole text", prose.prose(Path("a.py"), '"""A whole text\nof two lines."""\n'))

    def test_standard_words_are_not_counted(self):
        self.assertEqual(prose.rate(["A standard task with a basket."]), (6, 0.0))


class Sentences(unittest.TestCase):
    def test_code_tables_and_headings_are_no_sentences(self):
        text = "# One two three\n\n| a | b |\n|---|---|\n\nA short one. Another one.\n\n```gdscript\nvar a := 1\n```\n"
        self.assertEqual([part for part in prose.sentences(text) if part], ["A short one.", "Another one."])

    def test_a_list_item_is_a_sentence_of_its_own(self):
        self.assertEqual(list(prose.sentences("- one\n- two\n1. three")), ["- one", "- two", "1. three"])


class Checks(unittest.TestCase):
    def check(self, name, text):
        with tempfile.TemporaryDirectory() as folder:
            for _, place, _ in prose.GROUPS:
                (Path(folder) / place).mkdir(parents=True, exist_ok=True)
            (Path(folder) / name).write_text(text, encoding="utf-8")
            with contextlib.redirect_stdout(io.StringIO()) as output:
                return prose.check(Path(folder)), output.getvalue()

    def test_plain_text_is_clean(self):
        self.assertTrue(self.check("README.md", "Undergrowth generates grass. It has levels of detail.")[0])

    def test_words_for_persons_are_found_and_the_file_is_named(self):
        clean, output = self.check("extension/a.hpp", "/// Whoever stands there is told.\n")
        self.assertFalse(clean)
        self.assertIn("a.hpp: 3", output)

    def test_a_long_sentence_is_found(self):
        clean, output = self.check("README.md", "word " * 41 + "end.")
        self.assertFalse(clean)
        self.assertIn("README.md: 42 words", output)
        self.assertTrue(self.check("README.md", "word " * 39 + "end.")[0])


if __name__ == "__main__":
    unittest.main()
