"""The comparison of the library's engine calls with API dumps."""

import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tools"))

import engine_versions


def dump(**classes):
    """Classes by name, each of (base, {method: (hash, compatible hashes)})."""
    return {
        name: {"inherits": base, "methods": [
            {"name": method, "hash": own, "hash_compatibility": older} for method, (own, older) in methods.items()]}
        for name, (base, methods) in classes.items()
    }


OWN = dump(Node=("Object", {"get_name": (1, []), "set_name": (7, [5])}), Object=(None, {"free": (3, [])}))


class EngineVersions(unittest.TestCase):
    def test_calls_are_read_with_their_class(self):
        text = "a.os:\n                 U godot::Node::get_name() const\n0000 t godot::Node::set_name(int)\n"
        self.assertEqual(engine_versions.calls_of(text), {("Node", "get_name")})

    def test_a_method_of_a_base_class_is_found(self):
        self.assertEqual(engine_versions.find_method(OWN, "Node", "free")["hash"], 3)
        self.assertIsNone(engine_versions.find_method(OWN, "Node", "nothing"))

    def test_the_same_api_lacks_nothing(self):
        calls = {("Node", "get_name"), ("Node", "free"), ("Vector3", "length")}
        self.assertEqual(engine_versions.compare(calls, OWN, OWN), ([], []))

    def test_methods_that_are_missing_or_have_another_hash_are_named(self):
        other = dump(Node=("Object", {"set_name": (5, [])}), Object=(None, {}))
        calls = {("Node", "get_name"), ("Node", "set_name"), ("Node", "free")}
        missing, changed = engine_versions.compare(calls, OWN, other)
        self.assertEqual(missing, ["Node.free", "Node.get_name"])
        self.assertEqual(changed, ["Node.set_name"])

    def test_a_newer_version_may_list_the_hash_as_compatible(self):
        newer = dump(Node=("Object", {"set_name": (9, [7])}))
        self.assertEqual(engine_versions.compare({("Node", "set_name")}, OWN, newer), ([], []))

    def test_virtual_methods_with_overrides_are_compared(self):
        own = {"Node": {"methods": [{"name": "_process", "hash": 1, "is_virtual": True}, {"name": "_draw", "is_virtual": True},
                                    {"name": "get_name", "hash": 2, "is_virtual": False}]}}
        self.assertEqual(engine_versions.virtual_calls({"_process", "get_name"}, own), {("Node", "_process")})
        self.assertIn("_get_aabb", engine_versions.overridden(engine_versions.ROOT / "extension/godot"))

    def test_functions_of_a_newer_interface_are_named(self):
        table = [{"name": "a", "since": "4.5"}, {"name": "b", "since": "4.6"}, {"name": "c", "since": "4.10"}]
        self.assertEqual(engine_versions.newer_functions(table, {"a", "c"}, "4.6"), ["c"])
        self.assertEqual(engine_versions.newer_functions(table, {"a", "b"}, "4.5"), ["b"])

    def test_the_add_on_states_the_oldest_version(self):
        text = (engine_versions.ADD_ON / "undergrowth.gdextension").read_text(encoding="utf-8")
        self.assertIn(f'compatibility_minimum = "{engine_versions.VERSIONS[0]}"', text)


if __name__ == "__main__":
    unittest.main()
