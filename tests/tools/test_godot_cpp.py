"""The submodule godot-cpp: a clone without it builds as before, and a built one is used by default."""

import json
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tools"), str(ROOT / "extension/binding")]

from building import godot_cpp
from dry_run import dry_run, make_checkout
from generate import read_class_list

SUFFIX = "linux.template_debug.x86_64"


class GodotCpp(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.root = Path(scratch.name).resolve()

    def choose(self, named="", suffixes=(SUFFIX,), is_own_compiler=True, words=("build",)):
        return godot_cpp.chosen(str(self.root), named, suffixes, "linux", is_own_compiler, words)

    def put_library(self, suffix=SUFFIX):
        library = Path(godot_cpp.library(self.root / godot_cpp.SUBMODULE, suffix, "linux"))
        library.parent.mkdir(parents=True, exist_ok=True)
        library.touch()
        return str(self.root / godot_cpp.SUBMODULE)

    def test_without_a_built_submodule_the_binding_is_the_bundled_one(self):
        self.assertEqual(self.choose(), "")
        self.put_library("linux.template_release.x86_64")
        self.assertEqual(self.choose(), "")

    def test_a_built_submodule_is_used_by_default(self):
        folder = self.put_library()
        self.assertEqual(self.choose(), folder)
        self.assertEqual(self.choose(named="no"), "")
        self.assertEqual(self.choose(named="/other"), "/other")

    def test_what_the_submodule_does_not_fit_has_the_bundled_binding(self):
        self.put_library()
        self.put_library("linux.template_release.x86_64")
        self.assertEqual(self.choose(suffixes=(SUFFIX, "linux.template_release.x86_64")), "")
        self.assertEqual(self.choose(is_own_compiler=False), "")
        for word in godot_cpp.BUNDLED_WORDS:
            self.assertEqual(self.choose(words=(word,)), "")

    def test_the_profile_lists_the_classes_in_use(self):
        listed = self.root / "classes.txt"
        listed.write_text("# Words.\nArea3D\n\nNode3D\n")
        profile = Path(godot_cpp.write_profile(self.root, read_class_list(listed)))
        names = json.loads(profile.read_text())["enabled_classes"]
        self.assertEqual(names, ["Area3D", "Node3D", *godot_cpp.IN_SIGNATURES])

    def test_libraries_of_both_kinds_are_built_with_the_definitions_of_the_add_on(self):
        for kind, reload in (("template_debug", "yes"), ("template_release", "no")):
            words = godot_cpp.words_for("api.json", "profile.json", "linux", "x86_64", kind, True, 2)
            for word in (f"target={kind}", f"use_hot_reload={reload}", "custom_api_file=api.json", "threads=yes"):
                self.assertIn(word, words)

    def test_an_empty_submodule_is_one_error_with_the_remedy(self):
        with self.assertRaisesRegex(godot_cpp.NotInitialised, "git submodule update --init --checkout godot-cpp"):
            godot_cpp.build(["scons"], str(self.root), [], {})

    @unittest.skipUnless(sys.platform == "linux" and os.uname().machine == "x86_64", "the names are those of Linux on x86_64")
    def test_sconstruct_compiles_against_a_built_submodule(self):
        make_checkout(self.root)
        folder = self.put_library()
        status, output = dry_run(self.root, "build")
        self.assertEqual(status, 0, output[-2000:])
        self.assertIn(f"The library is compiled against godot-cpp in {folder}.", output)
        self.assertIn(f"-isystem {folder}/include", output)
        self.assertNotIn("extension/binding/src", output)


@unittest.skipUnless((ROOT / ".git").exists(), "a checkout without git has no submodules")
class Submodule(unittest.TestCase):
    def test_it_is_pinned_and_no_clone_fetches_it_unasked(self):
        listed = subprocess.run(["git", "ls-files", "--stage", "godot-cpp"], cwd=ROOT, stdout=subprocess.PIPE, text=True).stdout
        self.assertRegex(listed, r"^160000 [0-9a-f]{40} 0\tgodot-cpp\n$")
        settings = subprocess.run(["git", "config", "--file", ".gitmodules", "--list"], cwd=ROOT, stdout=subprocess.PIPE,
                                  text=True).stdout.splitlines()
        self.assertIn("submodule.godot-cpp.path=godot-cpp", settings)
        self.assertIn("submodule.godot-cpp.update=none", settings)


if __name__ == "__main__":
    unittest.main()
