"""README matches the contents of the repository."""

import re
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
# The demo's species written in a script.
SPECIES = ROOT / "demo_project/script_species/foxtail.gd"
sys.path.insert(0, str(ROOT / "tools"))

import store

MAX_STILL_BYTES = 400_000  # Of all stills.


class Readme(unittest.TestCase):
    text = (ROOT / "README.md").read_text(encoding="utf-8")

    def test_its_species_in_a_script_is_the_demos_to_the_letter(self):
        scripts = re.findall(r"```gdscript\n(.*?)```", self.text, re.DOTALL)
        self.assertIn(SPECIES.read_text(encoding="utf-8"), scripts)
        self.assertIn(SPECIES.relative_to(ROOT).as_posix(), self.text)

    def test_its_first_sentence_has_ten_words(self):
        sentence = re.search(r"^# .*\n\n(.*?\.)\s", self.text, re.DOTALL).group(1)
        self.assertLessEqual(len(sentence.split()), 10, sentence)

    def test_its_first_screen_has_an_animation_and_six_stills(self):
        screen = self.text.partition("\n## ")[0]
        self.assertIn("(docs/demo.webp)", screen)
        stills = re.findall(r"\[!\[[^]]+\]\(docs/stills/(\w+)\.webp\)\]\((docs/guide/\w+\.md)\)", screen)
        self.assertEqual({name for name, _ in stills}, {*store.VIEWS.values(), *store.OTHER_STILLS})
        self.assertEqual(len(stills), 6)
        self.assertEqual({path.stem for path in store.STILLS.glob("*.webp")}, {name for name, _ in stills})
        self.assertLess(sum(path.stat().st_size for path in store.STILLS.iterdir()), MAX_STILL_BYTES)
        for _, page in stills:
            self.assertTrue((ROOT / page).is_file(), page)

    def test_its_commands_exist(self):
        usage = (ROOT / "run").read_text(encoding="utf-8") + (ROOT / "SConstruct").read_text(encoding="utf-8")
        words = {word for line in re.findall(r"\./run ([a-z ]+)", self.text) for word in line.split()[:1]}
        self.assertGreaterEqual(words, {"demo", "test"})
        for word in words - {"help"}:
            self.assertRegex(usage, rf"\b{word}\b")


if __name__ == "__main__":
    unittest.main()
