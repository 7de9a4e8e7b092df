@tool
extends RefCounted
## The add-on's texts in other languages, for the editor only.
##
## They are in a translation domain of their own and do not affect the texts of the editor or the
## user's game. Controls of the add-on use it by [method Object.set_translation_domain].

const DOMAIN := &"undergrowth"
const EDITOR_DOMAIN := &"godot.editor"
const LANGUAGE_SETTING := "interface/editor/editor_language"
const AUTO := "auto"
const FILE_TYPE := "po"


## Loads the translations beside this script. Call it before any control of the add-on is shown.
static func add() -> void:
	var domain := TranslationServer.get_or_add_domain(DOMAIN)
	domain.clear()
	for file in ResourceLoader.list_directory(_folder()):
		if file.get_extension() == FILE_TYPE:
			domain.add_translation(load(_folder().path_join(file)) as Translation)
	domain.set_locale_override(_choose_locale(domain))
	# Controls of the editor inside those of the add-on use the editor's texts (not in Godot 4.5).
	var of_editor := TranslationServer.get_or_add_domain(EDITOR_DOMAIN)
	if of_editor.has_method(&"get_translations"):
		for translation: Translation in of_editor.call(&"get_translations"):
			domain.add_translation(translation)


## Removes all of it.
static func remove() -> void:
	if TranslationServer.has_domain(DOMAIN):
		TranslationServer.remove_domain(DOMAIN)


## Returns [param message] in the user's language, for scripts that are not nodes.
static func text(message: String) -> String:
	return TranslationServer.get_or_add_domain(DOMAIN).translate(message)


## The editor lacks some languages. With the system's language it still uses the add-on's texts.
static func _choose_locale(domain: TranslationDomain) -> String:
	var wanted: String = EditorInterface.get_editor_settings().get_setting(LANGUAGE_SETTING)
	var system := OS.get_locale()
	if wanted == AUTO and domain.get_translation_object(system):
		return system
	return TranslationServer.get_tool_locale()


static func _folder() -> String:
	var own := preload("translations.gd") as Script
	return own.resource_path.get_base_dir()
