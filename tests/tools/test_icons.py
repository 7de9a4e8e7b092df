"""The icons of the classes look like the engine's own in the editor."""

import unittest
from pathlib import Path

ICONS = Path(__file__).resolve().parents[2] / "addons/undergrowth/icons"


class Icons(unittest.TestCase):
    def test_each_grows_with_the_editors_scale(self):
        icons = sorted(ICONS.glob("*.svg"))
        self.assertGreater(len(icons), 15)
        for icon in icons:
            options = icon.with_name(icon.name + ".import").read_text(encoding="utf-8")
            self.assertIn("editor/scale_with_editor_scale=true", options, icon.name)
            self.assertIn('"has_editor_variant": true', options, icon.name)


if __name__ == "__main__":
    unittest.main()
