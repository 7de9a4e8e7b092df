## Resident memory of a field, where the system reports it (Linux).
extends "res://tests/engine/field_harness.gd"

const MIX := "res://addons/undergrowth/mixes/meadow.tscn"
const BYTES_PER_PAGE := 4096
const PLANTS := 100_000
const FRAMES_OF_FREEING := 60
## Measured: 67 MB, and 92 to 101 MB with what the build freed.
const MAX_MEGABYTES := 80.0


func test_a_mix_keeps_no_memory_of_its_build() -> void:
	if not FileAccess.file_exists("/proc/self/statm"):
		return
	var before := _resident_megabytes()
	field = (load(MIX) as PackedScene).instantiate()
	field.size = Vector2.ONE * sqrt(PLANTS / field.density)
	await start()
	while field.is_building():
		await process_frame
	await frames(FRAMES_OF_FREEING)
	check(field.get_plant_count() > 0.9 * PLANTS, "%d plants" % field.get_plant_count())
	var own := _resident_megabytes() - before
	check(own < MAX_MEGABYTES, "%.1f MB" % own)


func _resident_megabytes() -> float:
	var file := FileAccess.open("/proc/self/statm", FileAccess.READ)
	return float(file.get_line().get_slice(" ", 1)) * BYTES_PER_PAGE / 1e6
