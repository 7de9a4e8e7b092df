"""Choosing the Debian mirror and its key from what the machine has configured."""

import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tools"))

from toolchain import debian

FILE = "/etc/apt/sources.list.d/debian.sources:1"


def row(uri, release, component="main", origin="Debian", entry=FILE):
    return "|".join((uri, release, component, origin, entry))


class Mirrors(unittest.TestCase):
    def uris(self, *rows, codename="bookworm"):
        return [uri for uri, _ in debian.choose_mirrors("\n".join(rows), codename)]

    def test_takes_the_release_and_not_its_security_archive(self):
        rows = [row("http://sec/", "bookworm-security"), row("http://deb/", "bookworm"), row("http://deb/", "bookworm-updates")]
        self.assertEqual(self.uris(*rows), ["http://deb/"])

    def test_skips_others_sources(self):
        rows = [row("https://node/", "nodistro", origin="Node"), row("https://docker/", "bookworm", "stable", "Docker"),
                row("https://tool/", "bookworm", "main", "Tool Maker"), row("http://deb/", "bookworm")]
        self.assertEqual(self.uris(*rows), ["http://deb/"])

    def test_without_lists_the_source_with_updates_comes_first(self):
        rows = [row("https://a-tool/", "bookworm", origin="$(ORIGIN)"), row("http://deb/", "bookworm", origin="$(ORIGIN)"),
                row("http://deb/", "bookworm-updates", origin="$(ORIGIN)")]
        self.assertEqual(self.uris(*rows), ["http://deb/", "https://a-tool/"])

    def test_a_machine_that_says_stable(self):
        self.assertEqual(self.uris(row("http://deb/", "stable")), ["http://deb/"])

    def test_no_installation_disc(self):
        self.assertEqual(self.uris(row("cdrom://[Debian]/", "bookworm")), [])

    def test_nothing_configured(self):
        self.assertEqual(debian.choose_mirrors("", "bookworm"), [])

    def test_names_the_file_without_its_line(self):
        self.assertEqual(debian.choose_mirrors(row("http://deb/", "bookworm"), "bookworm"),
                         [("http://deb/", "/etc/apt/sources.list.d/debian.sources")])


class Release(unittest.TestCase):
    def test_debian(self):
        self.assertEqual(debian.release_name('ID=debian\nVERSION_CODENAME=trixie\n'), "trixie")

    def test_quoted(self):
        self.assertEqual(debian.release_name('ID="debian"\nVERSION_CODENAME="forky"\n'), "forky")

    def test_another_distribution(self):
        self.assertIsNone(debian.release_name('ID=ubuntu\nID_LIKE=debian\nVERSION_CODENAME=noble\n'))


class Keys(unittest.TestCase):
    def test_the_named_keyring(self):
        with tempfile.NamedTemporaryFile(suffix="debian-archive-keyring.pgp") as key:
            self.assertEqual(debian.signing_key(f"URIs: http://deb\nSigned-By: {key.name}\n"), key.name)
            self.assertEqual(debian.signing_key(f"deb [arch=amd64 signed-by={key.name}] http://deb x main\n"), key.name)

    def test_a_named_file_that_is_not_there(self):
        self.assertIn(debian.signing_key("Signed-By: /no/such/key\n"), (None, debian.KEYRING))


if __name__ == "__main__":
    unittest.main()
