"""The workflows call words and options that exist, and check the documentation."""

import re
import shutil
import subprocess
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
WORKFLOWS = sorted((ROOT / ".github/workflows").glob("*.yml"))
STEP = re.compile(r"run: (?:\./run|python run)((?: [\w=.,*-]+)+)")
OPTION = re.compile(r'options\.Add\((?:\w+\()?"(\w+)"')
COMMAND = re.compile(r'(?:command|Alias)\("(\w+)"')


def steps_of(path):
    """The words of each call of ./run in a workflow."""
    return [words.split() for words in STEP.findall(path.read_text(encoding="utf-8"))]


class Workflows(unittest.TestCase):
    settings = (ROOT / "SConstruct").read_text(encoding="utf-8")
    commands = (ROOT / "tools/building/commands.scons").read_text(encoding="utf-8")

    def test_words_and_options_exist(self):
        words = set(COMMAND.findall(self.settings + self.commands))
        options = set(OPTION.findall(self.settings))
        steps = [step for path in WORKFLOWS for step in steps_of(path)]
        self.assertGreater(len(steps), 8)
        for step in steps:
            for word in step:
                self.assertIn(word.partition("=")[0], options if "=" in word else words, " ".join(step))

    def test_named_suites_and_scripts_exist(self):
        scripts = {path.stem.removeprefix("test_") for path in (ROOT / "tests/engine").glob("test_*.gd")}
        suites = (ROOT / "tests/run_tests.py").read_text(encoding="utf-8")
        for step in (step for path in WORKFLOWS for step in steps_of(path)):
            named = dict(word.split("=") for word in step if "=" in word)
            for suite in filter(None, named.get("suites", "").split(",")):
                self.assertIn(suite, suites)
            for script in filter(None, named.get("only", "").split(",")):
                self.assertIn(script, scripts)

    def test_documentation_and_versions_are_checked(self):
        steps = [" ".join(step) for path in WORKFLOWS for step in steps_of(path)]
        for wanted in ("lint", "test suites=tools", "versions"):
            self.assertIn(wanted, steps)
        self.assertTrue(any("only=shown_code" in step for step in steps))

    @unittest.skipUnless(shutil.which("actionlint"), "actionlint is not on PATH")
    def test_actionlint_finds_no_fault(self):
        done = subprocess.run(["actionlint", *map(str, WORKFLOWS)], capture_output=True, text=True)
        self.assertEqual(done.stdout, "")


if __name__ == "__main__":
    unittest.main()
