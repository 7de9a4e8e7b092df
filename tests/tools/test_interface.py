"""The table of the engine's functions contains exactly the used ones."""

import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "extension/binding"))

from generator import interface

NAMES = ["object_destroy", "variant_get", "packed_byte_array_operator_index"] + [f"unused_{i}" for i in range(100)]
HEADER = "".join(f"/**\n * @name {name}\n */\ntypedef void (*GDExtensionInterface{i})(int a);\n"
                 for i, name in enumerate(NAMES))
TABLE = "include/godot_cpp/generated/interface_functions.inc"


class Interface(unittest.TestCase):
    def test_functions_are_found_by_name_and_behind_macros(self):
        sources = ["internal::gde.object_destroy(p);", "#define AT packed_byte_array_operator_index\n#define OTHER x\n",
                   "gde.AT(this, 0)", "gde.m_name = 0; not_gde.variant_get();"]
        self.assertEqual(interface.used_names(sources), {"object_destroy", "packed_byte_array_operator_index"})

    def test_nobody_else_is_asked_for(self):
        self.assertEqual(interface.files(HEADER, {"variant_get"})[TABLE],
                         "GODOT_INTERFACE_FUNCTION(GDExtensionInterface1, variant_get)\n")

    def test_a_header_without_one_that_is_used_is_refused(self):
        with self.assertRaisesRegex(SystemExit, "has no image_ptrw"):
            interface.files(HEADER, {"variant_get", "image_ptrw"})


if __name__ == "__main__":
    unittest.main()
