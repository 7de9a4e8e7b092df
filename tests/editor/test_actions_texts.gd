@tool
extends "actions_test.gd"
## Texts in other languages: complete, used in the dock, and nowhere else.

const LANGUAGE := "hr"
const FOLDERS: Array[String] = ["res://addons/undergrowth/editor"]
const PLUGIN := "undergrowth"
const IN_CODE := '\\b(?:tr|tr_n|atr|atr_n|text)\\(\\s*"((?:[^"\\\\]|\\\\.)+)"'
const IN_SCENES := '(?m)^(?:text|tooltip_text|placeholder_text|title|ok_button_text) = "([^"]+)"'
## Internal texts, and texts that are the same in every language.
const NOT_TEXTS: Array[String] = ["res://", "24, 12, 6, 3"]
## One text of each page and of each kind of control.
const SAMPLES: Dictionary[String, String] = {
	"Add to Scene": "Dodaj u scenu",
	"Strength": "Snaga",
	"All": "Sve",
}


func test_every_text_is_in_every_language() -> void:
	var texts := _collect_texts()
	check(texts.size() > 50, "%d texts were found" % texts.size())
	for translation in _domain().find_translations(LANGUAGE, false):
		var known := translation.get_message_list()
		for text in texts:
			check(text in known, "%s: missing in %s.po: %s" % [texts[text], LANGUAGE, text])


func test_the_dock_speaks_the_chosen_language() -> void:
	await open_panel()
	await _choose("Tulip")
	var before := _domain().get_locale_override()
	_speak(LANGUAGE)
	await frames(3)
	for text in SAMPLES:
		check_equal(part("Browser/Actions").tr(text), SAMPLES[text], text)
	var files := part("Browser/Actions").tr_n("%d file: %s", "%d files: %s", 5) % [5, "a"]
	check_equal(files, "5 datoteka: a", "the third plural")
	check_equal(Translations.text("Add Plant"), "Dodavanje biljke", "name of a step")
	await take_picture("croatian")
	await _use("Bake")
	await take_dialog_picture(_dialog("ConfirmationDialog"), "bake_croatian")
	await click((_dialog("ConfirmationDialog") as ConfirmationDialog).get_cancel_button())
	_speak(before)
	await frames(2)
	check_equal(part("Browser/Actions").tr("Strength"), "Strength", "back in English")


func test_no_text_reaches_the_editor_or_the_game() -> void:
	_speak(LANGUAGE)
	for text in SAMPLES:
		check_equal(TranslationServer.translate(text), StringName(text), "for the game")
		check_equal(EditorInterface.get_base_control().tr(text), text, "for the editor")
	_speak("en")


func test_the_plugin_takes_its_texts_away() -> void:
	EditorInterface.set_plugin_enabled(PLUGIN, false)
	await frames(5)
	check(not TranslationServer.has_domain(Translations.DOMAIN), "the domain is gone")
	EditorInterface.set_plugin_enabled(PLUGIN, true)
	await frames(5)
	check(_domain().has_translation_for_locale(LANGUAGE, true), "it is back")
	check(await until(func() -> bool: return dock() != null), "the dock is back")


func _domain() -> TranslationDomain:
	return TranslationServer.get_or_add_domain(Translations.DOMAIN)


func _speak(locale: String) -> void:
	_domain().set_locale_override(locale)
	dock().propagate_notification(Node.NOTIFICATION_TRANSLATION_CHANGED)


## Returns each text with its file.
func _collect_texts() -> Dictionary[String, String]:
	var texts: Dictionary[String, String] = {}
	for folder in FOLDERS:
		_collect_from(folder, texts)
	return texts


func _collect_from(folder: String, texts: Dictionary[String, String]) -> void:
	for file in DirAccess.get_files_at(folder):
		var pattern: String = {"gd": IN_CODE, "tscn": IN_SCENES}.get(file.get_extension(), "")
		if pattern.is_empty():
			continue
		var source := FileAccess.get_file_as_string(folder.path_join(file))
		for found in RegEx.create_from_string(pattern).search_all(source):
			var text := found.get_string(1).c_unescape()
			if text not in NOT_TEXTS:
				texts[text] = file
	for below in DirAccess.get_directories_at(folder):
		_collect_from(folder.path_join(below), texts)
