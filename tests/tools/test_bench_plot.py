"""The contents of the plot of ./run bench, without drawing it."""

import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tools"))

import bench_plot  # noqa: E402  (the path above comes first)


def row(name, plants, time, **more):
    return {"name": name, "plants": plants, "threads": 1, "median_ms": time, **more}


class Series(unittest.TestCase):
    def test_points_ascend(self):
        rows = [row("plant3d_held", 1000, 2.0), row("plant3d_held", 100, 0.2)]
        self.assertEqual(bench_plot.series_in(rows), [("plant3d_held", [(100, 0.2), (1000, 2.0)])])

    def test_the_quickest_counts(self):
        rows = [row("jolt", 100, 3.0), row("jolt", 100, 1.0)]
        self.assertEqual(bench_plot.series_in(rows), [("jolt", [(100, 1.0)])])

    def test_of_fields_those_in_a_headless_engine_count(self):
        rows = [row("field_frame", 100, 3.0, renderer="headless"), row("field_frame", 100, 1.0, renderer="forward_plus")]
        self.assertEqual(bench_plot.series_in(rows), [("field_frame", [(100, 3.0)])])

    def test_unknown_rows_and_rows_without_a_time_are_left_out(self):
        rows = [row("mesh", 500, 1.0), row("jolt", 1000, 0.0), row("jolt", 0, 1.0), {"name": "memory_bandwidth"}]
        self.assertEqual(bench_plot.series_in(rows), [])


class Labels(unittest.TestCase):
    def test_series_that_end_together_are_one_column(self):
        measured = [("field_frame", [(1009, 0.1), (99938, 1.0)]), ("jolt", [(10000, 1.0)]), ("plant3d_held", [(9999, 1.0)])]
        self.assertEqual(bench_plot.columns_of(measured), [["field_frame"], ["jolt", "plant3d_held"]])

    def test_labels_with_room_stay(self):
        self.assertEqual(bench_plot.spread([0.5, 0.1, 0.9], 0.1), [0.5, 0.1, 0.9])

    def test_labels_at_one_place_stand_around_it(self):
        places = bench_plot.spread([0.5, 0.5, 0.5], 0.1)
        for place, expected in zip(places, (0.4, 0.5, 0.6)):
            self.assertAlmostEqual(place, expected)

    def test_labels_keep_their_order_and_distance(self):
        wanted = [0.31, 0.30, 0.35, 0.0, 0.28]
        places = bench_plot.spread(wanted, 0.05)
        self.assertEqual(sorted(range(5), key=lambda i: places[i]), sorted(range(5), key=lambda i: wanted[i]))
        ascending = sorted(places)
        self.assertTrue(all(b - a > 0.05 - 1e-9 for a, b in zip(ascending, ascending[1:])))


class Texts(unittest.TestCase):
    def test_times_have_units(self):
        texts = [bench_plot.time_text(time) for time in (2e-5, 0.001, 0.01, 15.0, 1000.0)]
        self.assertEqual(texts, ["20 ns", "1 µs", "10 µs", "15 ms", "1 s"])

    def test_thousands_are_apart(self):
        self.assertEqual(bench_plot.count_text(1000000.0), "1\u202f000\u202f000")


if __name__ == "__main__":
    unittest.main()
