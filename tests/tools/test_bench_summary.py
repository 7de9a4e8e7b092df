"""The summary of the rows of ./run bench."""

import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tools"))

import bench_summary  # noqa: E402  (the path above comes first)


def row(name, plants, time, **more):
    return {"name": name, "plants": plants, "threads": 1, "median_ms": time, **more}


class Lines(unittest.TestCase):
    def test_shares_of_what_the_processor_can_do(self):
        reported = bench_summary.lines([row("step_spring", 10000, 1.0, level="avx2", g_plant_steps=2.5, compute_share=0.5,
                                        memory_share=0.125)])
        self.assertEqual(reported, ["step_spring, avx2, 10,000 plants: 2.50 G plant-steps/s, 50 % of what the core can "
                                "compute, 12.5 % of what its memory can move"])

    def test_peers_are_compared_at_about_as_many_plants(self):
        reported = bench_summary.lines([row("jolt", 1000, 2.0), row("field_frame", 1009, 0.01, renderer="headless"),
                                    row("field_frame", 1009, 1.0, renderer="forward_plus")])
        self.assertEqual(reported, ["1,000 plants: a field is 200 times faster than Jolt body and pin joint"])

    def test_a_difference_below_nothing_is_no_time(self):
        reported = bench_summary.lines([row("plant3d_held", 10000, -0.1), row("field_frame", 10001, 0.01, renderer="headless")])
        self.assertEqual(reported, [])

    def test_changes_have_their_worst(self):
        reported = bench_summary.lines([row("field_tiles", 1000, 2.0, worst_ms=3.0, workers_us_per_plant=0.75)])
        self.assertEqual(reported, ["field_tiles, 1,000 plants: 2.00 ms, 3.00 ms at worst",
                                "field_tiles: 0.75 µs of a core place and build a plant"])

    def test_scenes_have_counts_and_the_growth_of_their_memory(self):
        drawn = dict(draw_calls=300, shadow_draw_calls=1200, primitives=1.5e6, shadow_primitives=2.5e6)
        times = dict(first_plant_ms=80.0, all_plants_ms=900.0, processor_ms=700.0)
        reported = bench_summary.lines([row("scene", 1000, 0.1, video_mb=2.0, **drawn),
                                        row("scene", 11000, 0.1, video_mb=5.0, **drawn),
                                        row("scene", 1000, 0.1, resident_mb=10.0, **times),
                                        row("scene_still", 1000, 0.1, resident_mb=0.0, **times),
                                        row("scene", 11000, 0.1, resident_mb=16.0, **times)])
        self.assertEqual(reported[0], "scene, 1,000 plants: 300 draw calls and 1,200 for shadows; 1.50 and 2.50 M "
                                      "primitives; 2 MB of video memory")
        self.assertEqual(reported[3], "scene_still, 1,000 plants: the first after 80 ms, all after 900 ms, "
                                      "700 ms of processors' time; 0 MB resident")
        self.assertEqual(reported[5:], ["scene: 600 bytes of resident memory a plant from 1,000 to 11,000",
                                        "scene: 300 bytes of video memory a plant from 1,000 to 11,000"])

    def test_the_ladder_has_lines_for_each_renderer(self):
        reported = bench_summary.lines([row("field_frame", 99938, 1.0, renderer="forward_plus"),
                                    row("field_frame_main", 99938, 0.25, renderer="forward_plus", share=0.25),
                                    row("field_frame_interval_4", 99938, 0.3, renderer="forward_plus")])
        self.assertEqual(reported, ["forward_plus: a frame of 100,000 plants 1.000 ms, main thread 0.250 ms (25 %)",
                                "forward_plus: field_frame_interval_4 30 % of that"])

    def test_stems_are_compared_with_springs(self):
        reported = bench_summary.lines([row("page_spring", 10000, 1.0, level="avx2"),
                                    row("page_stem", 10000, 1.5, level="avx2"),
                                    row("page_stem", 10000, 9.0, level="baseline"),
                                    row("field_frame_spring", 99938, 2.0, renderer="headless"),
                                    row("field_frame_stems", 99938, 3.0, renderer="headless")])
        self.assertEqual(reported, ["page_stem, avx2, 10,000 plants: 1.50 times the spring law's page",
                                "headless: a frame of 100,000 stems 1.50 times that of springs"])

    def test_air_is_compared_with_waves_and_joints_with_their_peer(self):
        reported = bench_summary.lines([row("field_frame_stems", 99938, 2.0, renderer="headless"),
                                    row("field_frame_stems_air", 99938, 3.0, renderer="headless"),
                                    row("stem_4_held", 1000, 7.0, renderer="headless"),
                                    row("spring_bone_4", 1000, 10.0, renderer="headless")])
        self.assertEqual(reported, ["headless: a frame of 100,000 stems in air 1.50 times that in waves",
                                "headless: 1,000 plants of four joints 0.70 times SpringBoneSimulator3D's time"])

    def test_fills_have_their_threads_and_memory(self):
        times = {"workers_ms": 200.4, "processor_ms": 540.2, "bytes_per_plant": 80.6}
        reported = bench_summary.lines([row("field_fill_of_tufts", 99959, 500.1, **times),
                                    row("field_fill", 99959, 300.0)])
        self.assertEqual(reported, ["100,000 tufts of five species are there after 500 ms, 540 ms of processors' time, of "
                                "which workers have 200 ms; 81 bytes a plant"])

    def test_times_of_a_graphics_card_have_a_line_each(self):
        times = {"renderer": "mobile", "adapter": "Card", "gpu_ms": 30.417}
        reported = bench_summary.lines([{"name": "scene_card", "plants": 97179, "drawn": "full", **times},
                                        {"name": "card_plant_parts", "vertices": 4000560, **times}])
        self.assertEqual(reported, ["scene_card, mobile, Card: 30.42 ms of the card for 97,179 plants, full",
                                    "card_plant_parts, mobile, Card: 30.42 ms of the card for 4,000,560 vertices"])

    def test_instructions_of_a_kernel_have_a_line(self):
        row = {"name": "step_stem", "plants": 4096, "sse2": 50.97, "avx2": 21.87, "neon": 42.27, "hash": "0"}
        self.assertEqual(bench_summary.lines([row]),
                         ["step_stem: 51.0 instructions per plant with SSE2, 21.9 with AVX2, 42.3 with NEON; the same bits"])

    def test_nothing_measured_is_no_line(self):
        self.assertEqual(bench_summary.lines([]), [])


if __name__ == "__main__":
    unittest.main()
