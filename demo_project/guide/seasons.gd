extends "sheet.gd"
## One field in four seasons, by one parameter of its shader.

const SHADER := preload("season.gdshader")
const SEASONS: Dictionary[String, Color] = {
	"spring": Color(0.9, 1.0, 0.75),
	"summer": Color(1.0, 0.95, 0.7),
	"autumn": Color(1.0, 0.72, 0.42),
	"winter": Color(0.95, 0.86, 0.86),
}


func _fill(row: HBoxContainer) -> void:
	for season in SEASONS:
		var from := Vector3(0.0, 1.6, 4.4)
		var world := add_cell(row, season, from, Vector3(0.0, 0.2, 0.0), 36.0)
		var material := ShaderMaterial.new()
		material.shader = SHADER
		material.set_shader_parameter(&"season", SEASONS[season])
		var field := make_field({"meadow_grass": 8.0, "yarrow": 1.0}, 40.0, Vector2(5.0, 5.0))
		for listed in field.species:
			listed.species = listed.species.duplicate()
			listed.species.material = material
		world.add_child(field)
