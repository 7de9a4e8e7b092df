## Many small fields: their steps share a task of the worker threads.
extends "res://tests/engine/field_harness.gd"

const FIELDS := 24
const FRAMES := 30
const LEFT_TO_FREE := 4

var _beds: Array[PlantField3D] = []


func after_each() -> void:
	super()
	for bed in _beds:
		if is_instance_valid(bed):
			bed.free()
	_beds.clear()


func test_equal_fields_among_many_move_alike() -> void:
	await _add_beds(FIELDS)
	var before := all_tips(_beds[0])
	await frames(FRAMES)
	for bed in _beds:
		bed.simulation_enabled = false
	var own := all_tips(_beds[0])
	check(own.size() > 40, "%d plants" % own.size())
	check(own != before, "its plants do not move")
	for bed in _beds:
		check_equal(all_tips(bed), own)


func test_fields_may_be_freed_between_their_frame_and_the_steps() -> void:
	await _add_beds(FIELDS)
	for round_number in LEFT_TO_FREE:
		# Runs after all beds have processed the frame, before its deferred calls.
		var last := FreeingNode.new()
		last.beds = _beds.slice(0, 5)
		_beds = _beds.slice(5)
		root.add_child(last)
		await frames(2)
		last.free()
	check_equal(_beds.size(), FIELDS - 5 * LEFT_TO_FREE)
	var before := all_tips(_beds[0])
	await frames(FRAMES)
	check(all_tips(_beds[0]) != before, "the fields that remain do not move")


func test_the_motion_time_does_not_wait_for_the_steps() -> void:
	await _add_beds(FIELDS)
	var probe := TimeProbe.new()
	probe.bed = _beds[0]
	root.add_child(probe)
	await frames(FRAMES)
	for i in probe.in_frame.size() - 1:
		check_near(probe.in_frame[i], probe.after_frame[i], 1e-9)
	probe.free()


func _add_beds(count: int) -> void:
	var wind := PlantWind.new()
	wind.travel_speed = 0.0
	for i in count:
		var bed := PlantField3D.from_species([GrassFunction.new(), TulipFunction.new()])
		bed.size = Vector2(2, 2)
		bed.density = 20.0
		bed.wind = wind
		bed.simulation_enabled = false
		root.add_child(bed)
		_beds.append(bed)
	for bed in _beds:
		await settled(bed)
	for bed in _beds:
		bed.simulation_enabled = true


class FreeingNode:
	extends Node
	var beds: Array[PlantField3D] = []

	func _process(_delta: float) -> void:
		for bed in beds:
			bed.free()
		beds.clear()


class TimeProbe:
	extends Node
	var bed: PlantField3D
	var in_frame: Array[float] = []
	var after_frame: Array[float] = []

	func _process(_delta: float) -> void:
		in_frame.append(bed.get_motion_time())
		_note_after.call_deferred()

	func _note_after() -> void:
		bed.get_tip_position(bed.get_plant_ids()[0])  # Waits for the step.
		after_frame.append(bed.get_motion_time())
