"""Reading what suites print: no failure counts as a success."""

import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tools"), str(ROOT / "tests")]

import run_tests
from suites import engine, programs, result

BANNER = "Godot Engine v4.6.3\n"


class EngineOutput(unittest.TestCase):
    def failures(self, output, problem=None):
        return engine.read_output("engine:x", output, problem).failures

    def test_success(self):
        read = engine.read_output("engine:x", BANNER + "\nstart\nok test_a\nok test_b\ndone 2\n", None)
        self.assertEqual((read.passed, read.failures), (2, []))

    def test_a_failed_test_is_counted_once_though_the_status_tells_it_too(self):
        self.assertEqual(self.failures("\nstart\nnot ok test_a: why\ndone 1\n", "exit status 1"), ["test_a: why"])

    def test_errors_while_loading(self):
        self.assertEqual(self.failures("ERROR: no library\n\nstart\nok test_a\ndone 1\n"), ["ERROR: no library"])

    def test_a_leak_at_exit(self):
        leak = "WARNING: 3 ObjectDB instances were leaked at exit"
        self.assertEqual(self.failures(f"\nstart\nok test_a\ndone 1\n{leak}\n"), [leak])

    def test_a_crash_at_exit(self):
        self.assertEqual(self.failures("\nstart\nok test_a\ndone 1\n", "crashed with SIGSEGV"), ["crashed with SIGSEGV"])

    def test_a_crash_in_a_test(self):
        self.assertEqual(self.failures("\nstart\nok test_a\n", "crashed with SIGSEGV"), ["ended early: crashed with SIGSEGV"])

    def test_fewer_tests_than_announced(self):
        self.assertEqual(len(self.failures("\nstart\nok test_a\ndone 2\n")), 1)

    def test_no_tests_and_no_output(self):
        self.assertEqual(len(self.failures("\nstart\ndone 0\n")), 1)
        self.assertEqual(self.failures(""), ["ended early: no output"])


    def test_a_failure_in_random_order_tells_its_seed(self):
        output = "\nstart\nround 1 seed 7\nok test_a\nround 2 seed 8\nnot ok test_a: why\ndone 2\n"
        self.assertEqual(self.failures(output), ["test_a: why (order=random seed=8)"])


class Rounds(unittest.TestCase):
    def test_many_rounds_are_cut_into_processes_of_ten(self):
        cut = engine.Rounds(23, 100).cut()
        self.assertEqual([(one.times, one.seed) for one in cut], [(10, 100), (10, 110), (3, 120)])

    def test_one_round_as_written_says_nothing_to_the_engine(self):
        self.assertEqual([one.words() for one in engine.Rounds().cut()], [[]])
        self.assertEqual(engine.Rounds(2, 5).words(), ["--", "--rounds=2", "--seed=5"])

    def test_scripts_are_chosen_by_name(self):
        scripts = [Path(f"test_{name}.gd") for name in ("field", "field_ground", "motion", "motion_state")]
        chosen = [engine.subject(script) for script in scripts if engine.is_wanted(script, "field_*,motion")]
        self.assertEqual(chosen, ["field_ground", "motion"])
        self.assertTrue(all(engine.is_wanted(script, None) for script in scripts))


class Chosen(unittest.TestCase):
    ALL = ("picture", "editor", "tools", "core", "asan", "tsan", "engine:field", "engine:calls", "engine:threads",
           "engine:field_levels:gl_compatibility", "engine:field:2")

    def chosen(self, *words):
        return [name for name in self.ALL if run_tests.is_chosen(name, set(words))]

    def test_fast_is_the_core_and_the_headless_engine(self):
        self.assertEqual(self.chosen("fast"), ["core", "engine:field", "engine:calls", "engine:field:2"])

    def test_fast_may_be_named_beside_others(self):
        self.assertEqual(self.chosen("fast", "tools"), ["tools", *self.chosen("fast")])

    def test_without_names_all_run(self):
        self.assertEqual(self.chosen(), list(self.ALL))

    def test_the_slowest_scripts_exist(self):
        for subject in engine.SLOW:
            self.assertTrue((ROOT / f"tests/engine/test_{subject}.gd").exists(), subject)


class DoctestOutput(unittest.TestCase):
    TOTAL = "[doctest] test cases: {} | {} passed | {} failed | 0 skipped\n"

    def test_success(self):
        read = programs.read_doctest("core", self.TOTAL.format(3, 3, 0), None)
        self.assertEqual((read.passed, read.failures), (3, []))

    def test_failures_by_name(self):
        text = "TEST CASE:  a map is small\n\ny.cpp:1: MESSAGE: strokes: 3\n\n"
        text += "TEST CASE:  a stem bends\n\nx.cpp:1: ERROR: CHECK( a )\n" + self.TOTAL.format(3, 2, 1)
        self.assertEqual(programs.read_doctest("core", text, "exit status 1").failures, ["a stem bends"])

    def test_a_sanitizer_that_ends_the_program(self):
        text = "TEST CASE:  a\nx.cpp:3:5: runtime error: signed integer overflow\n    #0 main\n"
        read = programs.read_doctest("asan", text, "crashed with SIGABRT")
        self.assertEqual(read.failures, ["crashed with SIGABRT: x.cpp:3:5: runtime error: signed integer overflow"])

    def test_a_bad_status_after_success(self):
        read = programs.read_doctest("asan", self.TOTAL.format(1, 1, 0) + "ERROR: LeakSanitizer: detected\n", "exit status 23")
        self.assertEqual(len(read.failures), 1)


class Running(unittest.TestCase):
    def setUp(self):
        result.LOGS.mkdir(parents=True, exist_ok=True)

    def run_python(self, text, **options):
        return result.run("tools-sample", [sys.executable, "-c", text], **options)

    def test_output_and_status(self):
        self.assertEqual(self.run_python("print('x')"), ("x\n", None))
        self.assertEqual(self.run_python("raise SystemExit(3)")[1], "exit status 3")

    @unittest.skipUnless(sys.platform != "win32", "signals")
    def test_a_crash(self):
        self.assertEqual(self.run_python("import os; os.abort()")[1], "crashed with SIGABRT")

    def test_a_timeout_ends_the_program(self):
        self.assertEqual(self.run_python("import time; time.sleep(60)", timeout=0.5)[1], "not done after 0.5 s")

    def test_a_silent_program_is_ended_and_a_slow_one_that_speaks_is_not(self):
        speaks = "import time\nfor i in range(8): print(i, flush=True); time.sleep(0.5)"
        self.assertIsNone(self.run_python(speaks, silence=2)[1])
        self.assertEqual(self.run_python("import time; time.sleep(60)", silence=1)[1], "silent for 1 s")

    def test_a_program_that_is_not_there(self):
        self.assertIn("did not start", result.run("tools-sample", ["/no/such/program"])[1])


if __name__ == "__main__":
    unittest.main()
