"""Each translation contains exactly the texts of the editor's dock."""

import re
import unittest
from pathlib import Path

EDITOR = Path(__file__).resolve().parents[2] / "addons/undergrowth"
CLASSES = EDITOR.parents[1] / "extension/doc_classes"
STRING = r'"((?:[^"\\]|\\.)*)"'
# In scripts: texts passed to translation functions. Plural forms use the first text.
CALLS = re.compile(r"\b(?:tr|tr_n|Translations\.text)\(\s*" + STRING)
# In scenes: properties that the engine translates.
PROPERTIES = re.compile(r"^(?:text|tooltip_text|placeholder_text|title|ok_button_text|cancel_button_text|suffix|label)"
                        r" = " + STRING, re.MULTILINE | re.DOTALL)
ENTRY = re.compile(r'^msgid ((?:"(?:[^"\\]|\\.)*"\n?)+)', re.MULTILINE)
# Symbols, units and paths are the same in every language.
LETTERS = re.compile(r"[A-Za-z]{2}")
SAME = {"Hz", "res://"}


def shown():
    """Returns the texts of all scripts and scenes, with their positions."""
    found = {}
    for pattern, ending in ((CALLS, "*.gd"), (PROPERTIES, "*.tscn")):
        for path in sorted(EDITOR.rglob(ending)):
            for text in pattern.findall(path.read_text(encoding="utf-8")):
                if LETTERS.search(text) and text not in SAME:
                    found.setdefault(text.replace("\n", "\\n"), path.relative_to(EDITOR))
    return found


def ready_names():
    """Returns the titles of the add-on's species and mixes, by their files."""
    names = set()
    for path in [*EDITOR.glob("species/*.tres"), *EDITOR.glob("mixes/*.tscn")]:
        own = re.search(r'^\[resource\].*?^resource_name = "(.+?)"$', path.read_text(encoding="utf-8"), re.M | re.S)
        words = (own[1] if own else path.stem.replace("_", " ")).split(" ")
        names.add(" ".join(word[0].upper() + word[1:] for word in words))
    return names


def kinds():
    """Returns the titles of the kinds of parts: names of classes without their first word."""
    return {path.stem.removeprefix("Plant") for path in CLASSES.glob("Plant*.xml")}


def entries(path):
    joined = ["".join(re.findall(STRING, lines)) for lines in ENTRY.findall(path.read_text(encoding="utf-8"))]
    return {text for text in joined if text}


class Translations(unittest.TestCase):
    def test_there_are_texts_and_translations(self):
        self.assertGreater(len(shown()), 100)
        self.assertTrue(list(EDITOR.rglob("*.po")))

    def test_each_text_is_translated(self):
        for path in EDITOR.rglob("*.po"):
            missing = {text: str(place) for text, place in shown().items() if text not in entries(path)}
            self.assertEqual(missing, {}, path.name)

    def test_each_ready_species_and_mix_has_a_translated_name(self):
        self.assertGreater(len(ready_names()), 20)
        for path in EDITOR.rglob("*.po"):
            self.assertEqual(ready_names() - entries(path), set(), path.name)

    def test_no_translation_is_of_a_text_that_is_gone(self):
        sources = "".join(path.read_text(encoding="utf-8") for ending in ("*.gd", "*.tscn")
                          for path in sorted(EDITOR.rglob(ending)))
        for path in EDITOR.rglob("*.po"):
            idle = {text for text in entries(path) if text not in shown() and text not in sources and text not in ready_names() | kinds()}
            self.assertEqual(idle, set(), path.name)


if __name__ == "__main__":
    unittest.main()
