"""The engine's names in scripts and scenes, compared with those of another version."""

import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tools"))

import engine_versions
import script_names

NEW = script_names.Names({
    "classes": [
        {"name": "Object", "methods": [{"name": "call"}]},
        {"name": "Dock", "inherits": "Object", "methods": [{"name": "show_all"}], "properties": [{"name": "slot"}],
         "enums": [{"name": "Slot", "values": [{"name": "SLOT_LEFT"}]}]},
        {"name": "Server", "inherits": "Object", "methods": [{"name": "ask"}, {"name": "image"}]},
    ],
    "utility_functions": [{"name": "print_rich"}],
})
OLD = script_names.Names({
    "classes": [
        {"name": "Object", "methods": [{"name": "call"}]},
        {"name": "Server", "inherits": "Object", "methods": []},
        {"name": "Other", "inherits": "Object", "methods": [{"name": "ask"}]},
    ],
})


def lacking(text, declared=frozenset()):
    return script_names.lacking(script_names.used_in_script(text, declared), NEW, OLD)


class ScriptNames(unittest.TestCase):
    def test_classes_members_and_functions_that_are_missing_are_named(self):
        self.assertEqual(lacking("var a := Dock.new()\na.show_all()\na.slot = Dock.SLOT_LEFT\n"),
                         ["Dock", "SLOT_LEFT", "show_all", "slot"])
        self.assertEqual(lacking("func f():\n\tprint_rich(1)\n\tself.call(&'x')\n"), ["print_rich"])

    def test_a_member_of_another_class_does_not_stand_for_that_of_a_named_one(self):
        self.assertEqual(lacking("func f(a):\n\ta.ask()\n"), [])
        self.assertEqual(lacking("func f():\n\tServer.ask()\n"), ["Server.ask"])

    def test_comments_strings_and_own_names_do_not_count(self):
        self.assertEqual(lacking("# Dock\nvar a := \"Dock\" + 'slot'\nvar b := &\"show_all\"\nfunc image() -> void:\n\tpass\n"), [])
        self.assertEqual(lacking("func f(slot: int) -> void:\n\tslot += 1\n"), [])
        self.assertEqual(lacking("func f(a):\n\treturn a.image\n"), ["image"])
        self.assertEqual(lacking("func f(a):\n\treturn a.image\n", {"image"}), [])

    def test_scenes_use_types_and_properties(self):
        used = script_names.used_in_scene('[node name="A" type="Dock"]\nslot = 1\n')
        self.assertEqual(script_names.lacking(used, NEW, OLD), ["Dock", "slot"])

    def test_faults_name_the_file_and_leave_scripts_for_newer_versions_out(self):
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            (folder / "a.gd").write_text("var a := Dock.new()\n")
            (folder / "b.tscn").write_text("slot = 1\n")
            (folder / sorted(engine_versions.NEWER_ONLY)[0]).write_text("var a := Dock.new()\n")
            self.assertEqual(engine_versions.script_faults(NEW, OLD, folder), {"a.gd": ["Dock"], "b.tscn": ["slot"]})

    def test_scripts_for_newer_versions_exist(self):
        found = {path.name for path in engine_versions.ADD_ON.rglob("*.gd")}
        self.assertLessEqual(engine_versions.NEWER_ONLY, found)


if __name__ == "__main__":
    unittest.main()
