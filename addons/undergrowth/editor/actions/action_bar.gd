@tool
extends HFlowContainer
## What can be done with the chosen species.

const EditorState := preload("../editor_state.gd")

var _state: EditorState
var _undo: EditorUndoRedoManager
var _dock: Control


## Acts on the species of [param state]; dialogs open over [param dock].
func setup(state: EditorState, undo: EditorUndoRedoManager, dock: Control) -> void:
	_state = state
	_undo = undo
	_dock = dock
