## Processor time of this process. Only Linux reports it.
extends RefCounted


## Microseconds of its main thread (x) and of all remaining threads (y), or zeros on other systems.
static func spent() -> Vector2:
	var usec := Vector2.ZERO
	for thread in DirAccess.get_directories_at("/proc/self/task"):
		var own := _of_thread(int(thread))
		if int(thread) == OS.get_process_id():
			usec.x += own
		else:
			usec.y += own
	return usec


## Microseconds of the main thread, read at a lower cost than spent().
static func of_main_thread() -> float:
	return _of_thread(OS.get_process_id())


static func _of_thread(id: int) -> float:
	var file := FileAccess.open("/proc/self/task/%d/schedstat" % id, FileAccess.READ)
	return float(file.get_line().get_slice(" ", 0)) / 1000.0 if file else 0.0
