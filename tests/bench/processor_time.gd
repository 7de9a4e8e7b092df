## Processor time of this process. Only Linux reports it.
extends RefCounted


## Microseconds of its main thread (x) and of all remaining threads (y), or zeros on other systems.
static func spent() -> Vector2:
	var usec := Vector2.ZERO
	for thread in DirAccess.get_directories_at("/proc/self/task"):
		var file := FileAccess.open("/proc/self/task/%s/schedstat" % thread, FileAccess.READ)
		var own := float(file.get_line().get_slice(" ", 0)) / 1000.0 if file else 0.0
		if int(thread) == OS.get_process_id():
			usec.x += own
		else:
			usec.y += own
	return usec
