extends PanelContainer
## The bar at the lower edge: switches between the demo's scenes.
##
## Its buttons do, and the keys 1 to 8.

const SCENES: Array[String] = [
	"res://field/field.tscn",
	"res://meadow/meadow.tscn",
	"res://ladder/ladder.tscn",
	"res://levels/levels.tscn",
	"res://script_species/script_species.tscn",
	"res://stems/stems.tscn",
	"res://scythe/scythe.tscn",
	"res://paths/paths.tscn",
]


func _ready() -> void:
	var shown := get_tree().current_scene
	var path := shown.scene_file_path if shown else ""
	for index in SCENES.size():
		var button := %Buttons.get_child(index) as Button
		button.set_pressed_no_signal(SCENES[index] == path)
		button.pressed.connect(_open.bind(index))


func _unhandled_input(event: InputEvent) -> void:
	for index in SCENES.size():
		if event.is_action_pressed("scene_%d" % (index + 1)):
			_open(index)


func _open(index: int) -> void:
	get_tree().change_scene_to_file(SCENES[index])
