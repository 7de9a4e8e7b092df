"""README matches the contents of the repository."""

import re
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
# The demo's species written in a script.
SPECIES = ROOT / "demo_project/script_species/foxtail.gd"


class Readme(unittest.TestCase):
    text = (ROOT / "README.md").read_text(encoding="utf-8")

    def test_its_species_in_a_script_is_the_demos_to_the_letter(self):
        scripts = re.findall(r"```gdscript\n(.*?)```", self.text, re.DOTALL)
        self.assertIn(SPECIES.read_text(encoding="utf-8"), scripts)
        self.assertIn(SPECIES.relative_to(ROOT).as_posix(), self.text)

    def test_its_commands_exist(self):
        usage = (ROOT / "run").read_text(encoding="utf-8") + (ROOT / "SConstruct").read_text(encoding="utf-8")
        words = {word for line in re.findall(r"\./run ([a-z ]+)", self.text) for word in line.split()[:1]}
        self.assertGreaterEqual(words, {"demo", "test"})
        for word in words - {"help"}:
            self.assertRegex(usage, rf"\b{word}\b")


if __name__ == "__main__":
    unittest.main()
