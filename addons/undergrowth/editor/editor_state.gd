@tool
extends RefCounted
## State that the parts of the add-on's editor share: the chosen species or mix, the wind of the
## scene, and the text of the status line.

## Emitted when another species or mix was chosen, or none.
signal function_chosen
## Emitted when the user clicked tiles to use their species.
signal picked(functions: Array[PlantFunction], titles: PackedStringArray)
## Emitted when the wind was replaced or its properties changed.
signal wind_changed
## Emitted when [member sways] changed.
signal sway_changed
## Emitted when the status line has a new text.
signal reported(text: String, severity: Severity)
## Emitted after [signal reported] if its text is about the wind.
signal wind_reported(text: String, severity: Severity)
## Emitted after [signal reported] if its text is about this file.
signal file_reported(path: String)
## Emitted when long work started, progressed or ended; see [member work_total].
signal work_changed

enum Severity { INFO, WARNING, ERROR }

## Segments of the four levels of detail that the inspector shows and the add-on bakes, finest
## first.
const LEVELS: Array[int] = [24, 12, 6, 3]
## Segments of a plant near the camera.
const NEAR_SEGMENTS := 24
const FIRST_SEED := 1
const BREEZE: PlantWind = preload("res://addons/undergrowth/winds/breeze.tres")

## The chosen species, or null for none or a mix.
var function: PlantFunction:
	get:
		return _function
## The file of the add-on that [member function] was copied from, or null. While both are equal, a
## scene references the file.
var origin: PlantFunction
## The scene of the chosen mix, with a field as its root, or null.
var mix: PackedScene
## Title of the chosen species or mix.
var title := ""
## The file of the project that contains [member function]: a resource or a script.
var path := ""
## The reason that prevents a build of the chosen species and its solution, or an empty text.
var problem := ""
## The shown wind: that of the edited scene, or [member own_wind].
var wind: PlantWind:
	get:
		return _wind
	set(value):
		_watch(_wind, value, _on_wind_changed)
		_wind = value
		_on_wind_changed()

## The wind of the first plants of a scene without a wind. The dock owns it.
var own_wind: PlantWind

## True while the plants of the edited scene sway in the editor's 3D view, each in its own wind.
var sways: bool:
	get:
		return _sways
	set(value):
		if value != _sways:
			_sways = value
			sway_changed.emit()

## Title of the long work, number of its parts and of finished parts. 0 parts: no work.
var work_title := ""
var work_total := 0
var work_done := 0
## True after the user pressed Cancel. The worker checks it before each part.
var work_cancelled := false

var _function: PlantFunction
var _wind: PlantWind
var _sways := false
# True after the user has switched the sway off. New plants do not switch it on again.
var _is_still_by_user := false


func _init() -> void:
	var breeze: PlantWind = BREEZE.duplicate()
	breeze.direction = PI / 2.0
	own_wind = breeze
	wind = breeze


## Releases the chosen species and the wind. Call it when the dock closes.
func close() -> void:
	_watch(_function, null, _check)
	_watch(_wind, null, _on_wind_changed)
	_function = null
	_wind = null
	own_wind = null
	origin = null
	mix = null


## Chooses [param new_function], from the file [param new_path] or as a copy of [param new_origin].
## Null chooses none.
func choose(
	new_function: PlantFunction, new_path := "", new_title := "", new_origin: PlantFunction = null
) -> void:
	mix = null
	_take(new_function, new_path, new_title, new_origin)


## Chooses a mix instead of a species.
func choose_mix(new_mix: PackedScene, new_title: String) -> void:
	mix = new_mix
	_take(null, "", new_title, null)


## Switches the sway on or off for the user.
func choose_sway(on: bool) -> void:
	_is_still_by_user = not on
	sways = on


## Switches the sway on for new plants of the scene, unless the user has switched it off.
func show_new_plants_move() -> void:
	if not _is_still_by_user:
		sways = true


## Marks the chosen species as broken until its next change. [param text] contains the reason and
## its solution.
func fail(text: String) -> void:
	problem = text
	report(text, Severity.ERROR)


## Shows [param text] in the status line.
func report(text: String, severity := Severity.INFO) -> void:
	reported.emit(text, severity)


## Shows [param text] in the status line, and in that of the wind's panel.
func report_wind(text: String, severity := Severity.INFO) -> void:
	report(text, severity)
	wind_reported.emit(text, severity)


## Shows [param text] in the status line, with a button that shows the file [param path].
func report_file(text: String, path: String) -> void:
	report(text)
	file_reported.emit(path)


## Shows a progress bar for [param parts] parts of work called [param name].
func begin_work(name: String, parts: int) -> void:
	work_title = name
	work_total = parts
	work_done = 0
	work_cancelled = false
	work_changed.emit()


## Reports one finished part of the work.
func advance_work() -> void:
	work_done += 1
	work_changed.emit()


## Hides the progress bar.
func end_work() -> void:
	work_total = 0
	work_changed.emit()


## Cancels the work.
func cancel_work() -> void:
	work_cancelled = true
	work_changed.emit()


func _take(
	new_function: PlantFunction, new_path: String, new_title: String, new_origin: PlantFunction
) -> void:
	_watch(_function, new_function, _check)
	_function = new_function
	origin = new_origin
	path = new_path
	title = new_title
	_check()
	function_chosen.emit()


func _watch(before: Resource, after: Resource, listener: Callable) -> void:
	if before and before.changed.is_connected(listener):
		before.changed.disconnect(listener)
	if after:
		after.changed.connect(listener)


func _check() -> void:
	var found := ""
	if _function:
		found = _function.find_problem(0.0, NEAR_SEGMENTS, FIRST_SEED)
	if found == problem:
		return
	problem = found
	if problem.is_empty():
		report("")
	else:
		report("%s: %s" % [title, problem], Severity.ERROR)


func _on_wind_changed() -> void:
	wind_changed.emit()
