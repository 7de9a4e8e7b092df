"""The bench scene's report: each figure is required, errors count, and other add-ons are found by their files."""

import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))

from bench_scene import measure

SETTINGS = """config_version=5

[autoload]

Other="*res://other.tscn"
SimpleGrass="*res://addons/simplegrasstextured/singleton.tscn"

[rendering]

anti_aliasing/quality/msaa_3d=1

[shader_globals]

heightmap={
"type": "sampler2D",
"value": ""
}
"""


class BenchScene(unittest.TestCase):
    def report(self):
        return {"figures": {name: 1.0 for name in measure.FIGURES}}

    def test_a_complete_report_lacks_nothing(self):
        self.assertEqual(measure.missing_figures(self.report()), [])

    def test_each_missing_figure_is_named(self):
        for name in measure.FIGURES:
            report = self.report()
            del report["figures"][name]
            self.assertEqual(measure.missing_figures(report), [name])

    def test_only_figures_that_a_machine_may_lack_are_null(self):
        for name in measure.FIGURES:
            report = self.report()
            report["figures"][name] = None
            self.assertEqual(measure.missing_figures(report), [] if name in measure.MAY_BE_NULL else [name])

    def test_errors_of_the_engine_count(self):
        output = "Godot\nERROR: Failed.\n   at: here\nSCRIPT ERROR: Parse\nSHADER ERROR: x\nERROR: Started as root.\nerror: no\n"
        self.assertEqual(measure.errors_in(output), ["ERROR: Failed.", "SCRIPT ERROR: Parse", "SHADER ERROR: x"])

    def test_other_add_ons_are_found_by_a_file(self):
        for kind, file in measure.OTHERS.items():
            with tempfile.TemporaryDirectory() as folder:
                path = Path(folder) / file
                path.parent.mkdir(parents=True)
                path.touch()
                self.assertEqual(measure.kind_in(Path(folder)), kind)

    def test_a_folder_without_an_add_on_is_refused(self):
        with tempfile.TemporaryDirectory() as folder, self.assertRaisesRegex(SystemExit, "has none of the files"):
            measure.kind_in(Path(folder))

    def test_shader_globals_and_the_needed_autoload_are_taken_over(self):
        text = measure.settings_of(SETTINGS)
        self.assertIn('heightmap={\n"type": "sampler2D",\n"value": ""\n}', text)
        self.assertIn("SimpleGrass=", text)
        self.assertNotIn("Other=", text)
        self.assertNotIn("msaa", text)

    def test_readme_explains_each_figure_and_other_add_on(self):
        text = (ROOT / "tools/bench_scene/README.md").read_text(encoding="utf-8")
        for name in [*measure.FIGURES, *measure.OTHERS.values()]:
            self.assertIn(f"`{name}`", text)


if __name__ == "__main__":
    unittest.main()
