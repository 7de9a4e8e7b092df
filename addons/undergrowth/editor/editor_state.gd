@tool
extends RefCounted
## What the dock's pages share: the chosen species or mix, how it is shown, the wind of the preview,
## and what the status line says.

## Another species or mix was chosen, or none.
signal function_chosen
## The user chose it in the list, to do something with it.
signal picked
## The chosen species' properties changed. Its meshes may look different now.
signal function_edited
## [member height], [member seed_value] or [member segments] changed.
signal view_changed
## Another wind was put in, or the wind's properties changed.
signal wind_changed
## The status line has something to say.
signal reported(text: String, severity: Severity)
## Long work began, went on or ended; see [member work_total].
signal work_changed

enum Severity { INFO, WARNING, ERROR }

## Segments of the four levels of detail that the dock shows and bakes, finest first.
const LEVELS: Array[int] = [24, 12, 6, 3]
const DEFAULT_SEGMENTS := 12
## A light breeze, in newtons and hertz.
const PREVIEW_STRENGTH := 5.0
const PREVIEW_FREQUENCY := 0.4

## The chosen species; null while none is, or a mix.
var function: PlantFunction:
	get:
		return _function
## The file of the add-on that [member function] was copied from, or null. As long as they are equal
## a scene takes the file.
var origin: PlantFunction
## The scene of the chosen mix, with a field as its root; null while none is chosen.
var mix: PackedScene
## What the chosen species or mix is called.
var title := ""
## The file of the project that [member function] was read from: a resource or a script.
var path := ""
## What keeps the chosen species from being built, and what to do; empty where it builds.
var problem := ""
## Height of the previewed plant in metres; 0: the species' own.
var height := 0.0:
	set(value):
		height = value
		_on_view_changed()
## Which plant of the species is shown.
var seed_value := 1:
	set(value):
		seed_value = value
		_on_view_changed()
## Vertical segments of the previewed plant.
var segments := DEFAULT_SEGMENTS:
	set(value):
		segments = value
		_on_view_changed()
## The wind that blows on the preview. Change its properties, or put another in.
var wind: PlantWind:
	get:
		return _wind
	set(value):
		_watch(_wind, value, _on_wind_changed)
		_wind = value
		_on_wind_changed()

## What the long work is called, how many parts it has and how many are done. No work: 0 parts.
var work_title := ""
var work_total := 0
var work_done := 0
## True after the user pressed Cancel. Whoever does the work looks at it before each part.
var work_cancelled := false

var _function: PlantFunction
var _wind: PlantWind


func _init() -> void:
	var breeze := PlantWind.new()
	breeze.kind = PlantWind.KIND_WAVES
	breeze.strength = PREVIEW_STRENGTH
	breeze.frequency = PREVIEW_FREQUENCY
	breeze.direction = PI / 2.0
	wind = breeze


## Lets go of the chosen species and the wind. Call it when the dock closes.
func close() -> void:
	_watch(_function, null, _on_function_edited)
	_watch(_wind, null, _on_wind_changed)
	_function = null
	_wind = null
	origin = null
	mix = null


## Chooses [param new_function], read from [param new_path] or a copy of [param new_origin]; null
## chooses none.
func choose(
	new_function: PlantFunction, new_path := "", new_title := "", new_origin: PlantFunction = null
) -> void:
	mix = null
	_take(new_function, new_path, new_title, new_origin)


## Chooses a mix instead of a species.
func choose_mix(new_mix: PackedScene, new_title: String) -> void:
	mix = new_mix
	_take(null, "", new_title, null)


## The chosen species cannot be built until it is changed again: [param text] says why and what to
## do.
func fail(text: String) -> void:
	problem = text
	report(text, Severity.ERROR)
	function_edited.emit()


## Says [param text] in the status line.
func report(text: String, severity := Severity.INFO) -> void:
	reported.emit(text, severity)


## Shows a progress bar for [param parts] parts of work called [param name].
func begin_work(name: String, parts: int) -> void:
	work_title = name
	work_total = parts
	work_done = 0
	work_cancelled = false
	work_changed.emit()


## One part of the work is done.
func advance_work() -> void:
	work_done += 1
	work_changed.emit()


## Hides the progress bar.
func end_work() -> void:
	work_total = 0
	work_changed.emit()


## The user wants no more of it.
func cancel_work() -> void:
	work_cancelled = true
	work_changed.emit()


func _take(
	new_function: PlantFunction, new_path: String, new_title: String, new_origin: PlantFunction
) -> void:
	_watch(_function, new_function, _on_function_edited)
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
		found = _function.find_problem(height, segments, seed_value)
	if found == problem:
		return
	problem = found
	if problem.is_empty():
		report("")
	else:
		report("%s: %s" % [title, problem], Severity.ERROR)


func _on_function_edited() -> void:
	_check()
	function_edited.emit()


func _on_wind_changed() -> void:
	wind_changed.emit()


func _on_view_changed() -> void:
	_check()
	view_changed.emit()
