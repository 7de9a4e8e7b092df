## Time that processors have worked for this process. Linux tells such times, other systems don't.
extends RefCounted


## In microseconds: on its main thread (x), on all others (y); zeros where the system does not tell.
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
