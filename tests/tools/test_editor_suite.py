"""Recognition of crashes of the engine itself, after which the suite repeats a run and reports that."""

import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

sys.path[:0] = [str(Path(__file__).resolve().parents[2] / folder) for folder in ("tools", "tests")]

from suites import editor  # noqa: E402  (the path above comes first)

CRASH = """ok test_kind_is_chosen
handle_crash: Program crashed with signal 11
[1] /usr/lib/libc.so.6(+0x406b0) [0x7f1c2ff346b0] (??:0)
[2] {}
[3] /usr/bin/godot(+0x834cea) [0x5595f0c30cea] (??:0)
"""


class Crashes(unittest.TestCase):
    def test_input_methods_are_the_engines(self):
        for place in ("/usr/lib/libX11.so.6(XFilterEvent+0xeb) [0x7f]", "/lib/libX11.so.6(XUnsetICFocus+0x4) [0x7f]"):
            self.assertTrue(editor.INPUT_METHOD_CRASH.search(CRASH.format(place)), place)

    def test_others_are_ours(self):
        for place in ("/usr/bin/libundergrowth.so(+0x33) [0x7f]", "/lib/libX11.so.6(XFlush+0x4) [0x7f]"):
            self.assertFalse(editor.INPUT_METHOD_CRASH.search(CRASH.format(place)), place)

    def test_words_without_a_crash_are_none(self):
        self.assertFalse(editor.INPUT_METHOD_CRASH.search("ok XFilterEvent\n1 passed, 0 failed\n"))


class Repeats(unittest.TestCase):
    def run_once(self, *outputs):
        with tempfile.TemporaryDirectory() as folder:
            project = Path(folder) / "project"
            project.mkdir()
            (Path(folder) / "editor-pages.log").write_text("")
            answers = [(output, None) for output in outputs]
            with mock.patch.multiple(editor, FOLDER=project, LOGS=Path(folder)), \
                    mock.patch.object(editor, "start_editor", side_effect=answers):
                return editor.run_once("godot", "pages")

    def test_a_repeat_is_told(self):
        crash = CRASH.format("/usr/lib/libX11.so.6(XFilterEvent+0xeb) [0x7f]")
        read = self.run_once(crash, "start\nok test_a\n1 passed, 0 failed\n")
        self.assertEqual((read.passed, read.failures, len(read.notes)), (1, [], 1))
        self.assertIn("pages was begun once more", read.notes[0])

    def test_a_crash_of_ours_is_not_repeated(self):
        read = self.run_once(CRASH.format("/usr/bin/libundergrowth.so(+0x33) [0x7f]"))
        self.assertEqual((len(read.failures), read.notes), (1, []))


if __name__ == "__main__":
    unittest.main()
