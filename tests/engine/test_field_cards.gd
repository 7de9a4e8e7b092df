## Levels of fields in which cards replace small parts.
extends "res://tests/engine/field_harness.gd"

const FERN := "res://addons/undergrowth/species/male_fern.tres"
const LAWN := "res://addons/undergrowth/species/lawn_grass.tres"
const GRASS := "res://addons/undergrowth/species/meadow_grass.tres"
const YARROW := "res://addons/undergrowth/species/yarrow.tres"
const MEADOW := "res://addons/undergrowth/mixes/meadow.tscn"
## Flowers with cards at 5 segments, and the maximum error of their outlines (m).
const FLOWERS: Dictionary = {
	"yarrow": 0.006, "oxeye_daisy": 0.007, "red_clover": 0.0075, "buttercup": 0.01, "poppy": 0.009
}
const INCLUDE := '#include "res://addons/undergrowth/shaders/%s.gdshaderinc"\n'
const BEND := "shader_type spatial;\n" + INCLUDE % "undergrowth_bend"
const CARD := INCLUDE % "undergrowth_card"
const SOLID := BEND + "void vertex() { UNDERGROWTH_BEND }"
const CARDED := (
	BEND + CARD + "void vertex() { UNDERGROWTH_CARD_BEND }\nvoid fragment() { UNDERGROWTH_CARD }"
)
const POLLED := 10  # Frames after which a field notices the override.
const OWN := preload("res://addons/undergrowth/shaders/plant_parts.gdshader")

var fern: PlantFunction


func before_each() -> void:
	fern = (load(FERN) as PlantFunction).duplicate(true)
	field = PlantField3D.from_species([fern, load(LAWN)])
	field.density = 0.5
	field.size = Vector2(12, 12)
	field.simulation_enabled = false


func test_near_levels_of_fronds_have_cards_and_last_ones_have_none() -> void:
	await start()
	var carded := _carded(0)
	check(carded.count(1) >= 1, "of the fern: %s" % [carded])
	check_equal(carded[-1], 0, "last level of the fern")
	check_equal(_carded(1).count(1), 0, "a lawn has no groups of small parts")


func test_umbels_have_cards() -> void:
	field.free()
	field = PlantField3D.from_species([load(YARROW)])
	field.density = 0.5
	await start()
	check(_carded(0).count(1) >= 1, "cards of yarrow: %s" % [_carded(0)])


func test_cards_show_parts_that_only_some_plants_have() -> void:
	field.free()
	field = PlantField3D.from_species([load(GRASS)])
	field.density = 0.5
	await start()
	check(_carded(0).count(1) >= 1, "half of the grass has no panicle: %s" % [_carded(0)])


func test_cards_show_the_plant_with_most_kinds_of_parts() -> void:
	# Of the plants whose parts cards can show, the last one has neither leaves nor flowers.
	var yarrow := (load(YARROW) as PlantFunction).duplicate(true) as PlantFunction
	yarrow.has_stem = false
	var parts := yarrow.arrangements
	for arrangement in parts:
		arrangement.count = Vector2i(0, 1)
	var blade := PlantBlade.of({length = Vector2(0.1, 0.1), width = 0.01})
	parts.append(PlantArrangement.of({part = blade, layout = PlantArrangement.LAYOUT_GROUND}))
	for i in 5:
		var other := PlantBlade.of({length = Vector2(0.1, 0.1), width = 0.01 + 0.001 * i})
		parts.append(PlantArrangement.of({part = other, count = Vector2i(0, 1), layout = 3}))
	yarrow.arrangements = parts
	field.free()
	field = PlantField3D.from_species([yarrow])
	field.density = 0.5
	await start()
	check(_carded(0).count(1) >= 1, "cards of yarrow: %s" % [_carded(0)])


func test_cards_need_fewer_vertices_for_the_same_error() -> void:
	await start()
	var with_cards := _error_at(8)
	fern.material = _material(SOLID)
	await rested()
	check(with_cards < 0.5 * _error_at(8), "%f m, solid %f m" % [with_cards, _error_at(8)])


func test_flowers_of_the_meadow_are_exact_at_middle_distances() -> void:
	field.free()
	field = (load(MEADOW) as PackedScene).instantiate()
	field.size = Vector2(12, 12)
	field.simulation_enabled = false
	await start()
	var checked := 0
	for listed: Dictionary in field.get_statistics()["levels"]:
		var name := (listed["species"] as Resource).resource_path.get_file().get_basename()
		var at := Array(listed["segments"]).find(5)
		if name in FLOWERS and at >= 0:
			check(listed["errors"][at] < FLOWERS[name], "%s: %s" % [name, listed["errors"]])
			check_equal(listed["are_carded"][at], 1, "%s has cards at 5 segments" % name)
			checked += 1
	check_equal(checked, FLOWERS.size(), "flowers")


func test_levels_of_users_have_no_cards() -> void:
	field.levels = [PlantFieldLevel.of(12, 3.0), PlantFieldLevel.of(8)]
	await start()
	check_equal(_carded(0).count(1), 0, "cards")


func test_materials_without_the_include_get_solid_levels() -> void:
	fern.material = _material(SOLID)
	await start()
	check_equal(_carded(0).count(1), 0, "a shader without cards")
	fern.material = _material(CARDED)
	await rested()
	check(_carded(0).count(1) > 0, "a shader with cards")
	fern.material = ShaderMaterial.new()
	(fern.material as ShaderMaterial).shader = OWN
	await rested()
	check(_carded(0).count(1) > 0, "the add-on's shader")
	field.material_override = _material(SOLID)
	await frames(POLLED)
	await rested()
	check_equal(_carded(0).count(1), 0, "an override without cards")
	field.material_override = null
	await frames(POLLED)
	await rested()
	check(_carded(0).count(1) > 0, "without the override")
	fern.material = StandardMaterial3D.new()
	await rested()
	check_equal(_carded(0).count(1), 0, "a standard material")


func test_a_changed_species_gets_new_cards() -> void:
	await start()
	var before := _error_at(8)
	for arrangement: PlantArrangement in fern.arrangements:
		arrangement.carries = []
	await rested()
	check_equal(_carded(0).count(1), 0, "fronds without leaflets, before %f m" % before)


func _material(code: String) -> ShaderMaterial:
	var material := ShaderMaterial.new()
	material.shader = Shader.new()
	material.shader.code = code
	return material


func _listed(species: int) -> Dictionary:
	return field.get_statistics()["levels"][species]


func _carded(species: int) -> Array:
	return Array(_listed(species)["are_carded"])


func _error_at(segments: int) -> float:
	var listed := _listed(0)
	var at: int = Array(listed["segments"]).find(segments)
	return listed["errors"][at] if at >= 0 else INF
