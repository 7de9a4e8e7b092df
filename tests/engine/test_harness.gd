## Tests of the harness. An error that it misses would hide errors in all other tests.
extends "res://tests/engine/harness.gd"

var _built := false


func before_each() -> void:
	_built = true


func after_each() -> void:
	_built = false


func test_before_each_runs_first() -> void:
	check(_built, "before_each ran")


func test_equal_compares_types_too() -> void:
	check_equal(1, 1)
	_expect_failure(func() -> void: check_equal(1, 1.0))
	_expect_failure(func() -> void: check_equal("a", "b"))


func test_near_compares_numbers_vectors_and_colors() -> void:
	check_near(1.0, 1.001, 0.01)
	check_near(Vector3(1, 2, 3), Vector3(1, 2, 3.001), 0.01)
	check_near(Color.RED, Color(1, 0.001, 0), 0.01)
	_expect_failure(func() -> void: check_near(1.0, 1.1, 0.01))
	_expect_failure(func() -> void: check_near(NAN, 1.0, 0.01))


func test_errors_and_warnings_are_claimed_by_their_text() -> void:
	push_error("a bent stem")
	push_warning("a dry leaf")
	check_error("bent stem")
	check_error("dry leaf")
	check_error_count("bent stem", 0)


func test_an_error_of_a_thread_is_heard() -> void:
	var thread := Thread.new()
	thread.start(func() -> void: push_error("from a thread"))
	thread.wait_to_finish()
	check_error("from a thread")


func test_frames_pass_while_waiting() -> void:
	var before := Engine.get_process_frames()
	await frames(3)
	check_equal(Engine.get_process_frames() - before, 3, "frames")


func test_a_seed_decides_the_order_and_no_name_is_lost() -> void:
	var names: PackedStringArray = ["a", "b", "c", "d", "e", "f", "g"]
	var orders := {}
	for seed_value in 20:
		var order := shuffled(names, seed_value)
		check_equal(order, shuffled(names, seed_value), "the same seed's order")
		orders[order] = true
		order.sort()
		check_equal(order, names, "names")
	check(orders.size() > 15, "other seeds have other orders")


## Without the harness's steps before its exit, this script never ends.
func test_tasks_in_a_queue_do_not_hold_the_engine_at_its_exit() -> void:
	var last := 0
	for i in 2 * OS.get_processor_count():
		last = WorkerThreadPool.add_task(OS.delay_msec.bind(100))
	check(not WorkerThreadPool.is_task_completed(last), "the last task is still in the queue")


## Checks that [param checks] fails exactly once, and removes that failure.
func _expect_failure(checks: Callable) -> void:
	var before := _problems.size()
	checks.call()
	var failures := _problems.size() - before
	_problems.resize(before)
	check_equal(failures, 1, "failures")
