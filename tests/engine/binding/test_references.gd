## References that pass between scripts and C++ on every path. None is lost and none is leaked.
extends "res://tests/engine/harness.gd"


func after_each() -> void:
	check_equal(ProbeCounter.get_alive(), 0, "counters alive after the test")


func test_an_object_made_by_a_script_has_one_reference() -> void:
	var counter := ProbeCounter.new()
	check_equal(ProbeCounter.get_alive(), 1)
	check_equal(counter.get_reference_count(), 1)


func test_an_object_made_in_c_plus_plus_has_one_reference() -> void:
	var typed := ProbeCounter.make()
	check_equal(typed.get_reference_count(), 1, "typed call")
	var untyped: RefCounted = ClassDB.class_call_static("ProbeCounter", "make")
	check_equal(untyped.get_reference_count(), 1, "untyped call")
	ProbeCounter.make()
	check_equal(ProbeCounter.get_alive(), 2, "a dropped result is freed")


func test_an_object_of_the_engine_made_in_c_plus_plus_has_one_reference() -> void:
	var made := ProbeCounter.make_resource()
	check_equal(made.get_reference_count(), 1)
	check_equal(made.resource_name, "made")
	var gone: WeakRef = weakref(made)
	made = null
	check(gone.get_ref() == null, "the resource is freed")


func test_a_passed_reference_is_counted_while_it_is_used() -> void:
	var counter := ProbeCounter.new()
	var other := ProbeCounter.new()
	for i in 3:
		check(counter.pass(other) == other, "the same object comes back")
		check(counter.call("pass", other) == other, "the same object comes back untyped")
		check(counter.pass_variant(other) == other, "the same object comes back in a Variant")
		check(counter.count_of(other) >= 2, "the call holds one more")
	check(counter.pass(null) == null, "null passes")
	check_equal(counter.count_of(null), 0)
	check_equal(other.get_reference_count(), 1)


func test_a_held_reference_lives_as_long_as_its_holder() -> void:
	var holder := ProbeCounter.new()
	holder.hold(ProbeCounter.new())
	check_equal(ProbeCounter.get_alive(), 2)
	check_equal(holder.get_held().get_reference_count(), 2, "holder and result")
	holder.held = ProbeCounter.make()
	check_equal(ProbeCounter.get_alive(), 2, "the first is freed")
	check_equal(holder.held.get_reference_count(), 2, "as a property")
	holder.hold(null)
	check_equal(ProbeCounter.get_alive(), 1)
	var engine_object := Resource.new()
	holder.hold(engine_object)
	check_equal(engine_object.get_reference_count(), 2)
	holder = null
	check_equal(engine_object.get_reference_count(), 1)


func test_copies_moves_casts_and_variants_keep_the_count() -> void:
	var counter := ProbeCounter.new()
	check(counter.juggle(ProbeCounter.new()), "counts before and after differ")
	check_equal(ProbeCounter.get_alive(), 1)


func test_arrays_hold_references() -> void:
	var many := ProbeCounter.make_many(5)
	check_equal(ProbeCounter.get_alive(), 5)
	var first: RefCounted = many[0]
	check_equal(first.get_reference_count(), 2, "the array and this variable")
	first = null
	many.clear()
	check_equal(ProbeCounter.get_alive(), 0)
	check_equal(ProbeCounter.make_many().size(), 2, "default argument of a static method")


func test_an_object_can_give_out_itself() -> void:
	var counter := ProbeCounter.new()
	var same := counter.get_self()
	check(same == counter, "it is the same object")
	check_equal(counter.get_reference_count(), 2)


func test_threads_make_and_free_objects() -> void:
	var work := func(_index: int) -> void:
		for i in 200:
			var counter := ProbeCounter.make()
			counter.hold(ProbeResource.new())
			var node := ProbeDerived.new()
			node.speed = i
			node.free()
	var task := WorkerThreadPool.add_group_task(work, 8, 8)
	WorkerThreadPool.wait_for_group_task_completion(task)
	check_equal(ProbeCounter.get_alive(), 0)


func test_a_subclass_in_a_script_is_counted_too() -> void:
	var own := OwnCounter.new()
	var holder := ProbeCounter.new()
	holder.hold(own)
	check(holder.get_held() == own, "it is the same object")
	check_equal(own.get_reference_count(), 2)
	check_equal(holder.get_held().get("extra"), 7)


class OwnCounter:
	extends ProbeCounter
	var extra := 7
