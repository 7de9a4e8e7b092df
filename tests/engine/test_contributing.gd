## The recipes of CONTRIBUTING.md are correct. The code of the species recipe makes a species that
## passes the checks of the ready ones, and each file named in a recipe exists.
extends "res://tests/engine/harness.gd"

const Ready := preload("res://tests/engine/test_ready_species.gd")
const ShownCode := preload("res://tests/engine/shown_code.gd")
const SAVED := "user://moor_grass.tres"
## A species that each table of step 3 contains.
const LISTED := "poppy"


func test_the_species_recipe_makes_a_species_that_passes_all_checks() -> void:
	DirAccess.remove_absolute(SAVED)
	var path := ShownCode.find_file("CONTRIBUTING.md")
	var block := ShownCode.in_markdown(path, "CONTRIBUTING.md").filter(
		func(one: ShownCode.Block) -> bool: return one.language == "gdscript"
	)
	check_equal(block.size(), 1, "blocks of GDScript")
	var script := ShownCode.make_script(block[0])
	check_equal(script.reload(), OK, "the recipe compiles")
	var node: Node3D = script.new()
	node.call(&"show_it")
	node.free()
	var species := load(SAVED) as PlantFunction
	check(species != null, "the recipe saves a species")
	for segments: int in Ready.BUDGETS:
		check_equal(species.find_problem(0.0, segments, 1), "", "problem at %d" % segments)
		var count := species.generate_mesh(0.0, segments, 1).surface_get_array_len(0)
		check(
			count > 0 and count <= Ready.BUDGETS[segments], "%d vertices at %d" % [count, segments]
		)
	for arrangement: PlantArrangement in species.arrangements:
		check(arrangement.resource_name != "", "the arrangement has a name")
		check(arrangement.part.resource_name != "", "its part has a name")


func test_tables_of_the_species_recipe_list_the_ready_species() -> void:
	var recipe := _text("CONTRIBUTING.md").get_slice("### A new species", 1).get_slice("###", 0)
	var tables := RegEx.create_from_string("(?m)^   - `([^`]+)`").search_all(recipe)
	check_equal(tables.size(), 4, "tables")
	for table in tables:
		check(_text(table.get_string(1)).to_lower().contains(LISTED), table.get_string(1))


func test_files_that_recipes_name_exist() -> void:
	var named := RegEx.create_from_string("`((?:extension|addons|tests|demo_project)/[\\w/.]+)`")
	var found := named.search_all(_text("CONTRIBUTING.md"))
	check(found.size() > 12, "%d files are named" % found.size())
	for file in found:
		check(ShownCode.find_file(file.get_string(1)) != "", file.get_string(1))


func _text(name: String) -> String:
	return FileAccess.get_file_as_string(ShownCode.find_file(name))
