"""The estimate for graphics cards: reading the layer's log, and the formula."""

import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tools"))

import bench_summary  # noqa: E402  (the path above comes first)
from gpu import cards, log, measure  # noqa: E402
from toolchain.place import Missing  # noqa: E402

RECORDED = Path(__file__).parent / "gpu.log"


class Formula(unittest.TestCase):
    def test_all_simds_take_waves_of_64_vertices(self):
        card = cards.Card("one", "One", simds=2, clock=1e6)
        self.assertEqual(card.milliseconds(64, 2000), 1.0)
        self.assertEqual(card.milliseconds(640, 500), 2.5)


class Reader(unittest.TestCase):
    """Of a log that was recorded, less its other frames."""

    def setUp(self):
        self.log = log.read(RECORDED.read_text(encoding="utf-8"))

    def test_the_vertex_stage_has_cycles_and_registers(self):
        self.assertEqual(self.log.device, "Null hardware (RADV VANGOGH)")
        self.assertEqual(self.log.pipelines[17], log.Pipeline(True, attributes=8, cycles=2312.0, registers=128))
        self.assertEqual(self.log.pipelines[14], log.Pipeline(False, attributes=8, cycles=674.0, registers=80))

    def test_smaller_waves_take_more_of_them(self):
        text = "pipeline 1 vertex=0 colours=1 attributes=1\nstage 1 vertex subgroup=32; VGPRs=24; Inverse Throughput=100"
        self.assertEqual(log.read(text).pipelines[1].cycles, 200.0)

    def test_passes_are_told_apart_by_colour_and_target(self):
        passes = log.passes(self.log, "shader plant_cards", (1920, 1080))
        self.assertEqual({name: [draw.pipeline for draw in draws] for name, draws in passes.items()},
                         {"colour": [23], "depth": [20], "shadow": [22]})

    def test_the_last_whole_frame_before_a_mark_counts(self):
        text = RECORDED.read_text(encoding="utf-8").replace("mark shader plant_parts",
                                                            "draw 17 1920x1080 draws=9\nmark shader plant_parts")
        self.assertEqual(log.read(text).frames["shader plant_parts"], self.log.frames["shader plant_parts"])


class Rows(unittest.TestCase):
    def setUp(self):
        scenes = {97179: {"name": "gpu_scene", "plants": 97179, "primitives": 1781982, "shadow_primitives": 2985206}}
        recorded = log.read(RECORDED.read_text(encoding="utf-8"))
        self.rows = measure.rows_of(cards.CARDS[0], recorded, scenes)

    def test_shaders_have_cycles_by_pass(self):
        self.assertEqual([row["name"] for row in self.rows],
                         ["gpu_plant_parts", "gpu_plant_cards", "gpu_StandardMaterial3D", "gpu_scene"])
        self.assertEqual([self.rows[2][f"{one}_cycles"] for one in ("colour", "depth", "shadow")], [570.0, 209.0, 209.0])

    def test_a_scene_has_vertices_and_times_by_pass(self):
        row = self.rows[3]
        self.assertEqual(row["colour_vertices"], 2508851 + 72557)
        seconds = (2508851 * 2312 + 72557 * 2801) / 64 / (16 * 1.6e9)
        self.assertAlmostEqual(row["colour_ms"], 1000.0 * seconds)
        self.assertAlmostEqual(row["shadow_ms"], 1000.0 * 5007190 * 674 / 64 / (16 * 1.6e9))

    def test_counts_that_differ_from_the_engine_s_are_an_error(self):
        measure.check_counts(self.rows[3])
        with self.assertRaisesRegex(Missing, "the layer counts 1,781,982 colour_triangles"):
            measure.check_counts({**self.rows[3], "primitives": 1000000})

    def test_the_summary_has_a_line_for_each(self):
        lines = bench_summary.lines(self.rows)
        self.assertEqual(lines[0], "gpu_plant_parts, vangogh: 2,312 / 674 / 674 cycles of a SIMD for 64 vertices in "
                                   "colour / depth / shadow, 128 / 80 / 80 vector registers")
        self.assertEqual(lines[3], "gpu_scene, vangogh, 97,179 plants: an estimate of 6.80 ms for vertices "
                                   "(colour 3.66, depth 1.07, shadow 2.06)")


if __name__ == "__main__":
    unittest.main()
