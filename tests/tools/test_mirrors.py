"""Choosing the Debian mirror and its key from what the machine has configured."""

import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tools"))

from toolchain import debian

def row(mirror, release, component="main"):
    return (f"'{mirror}dists/{release}/{component}/binary-amd64/Packages.xz' "
            f"mirror_dists_{release}_{component}_binary-amd64_Packages 0 ")


class Mirrors(unittest.TestCase):
    def mirrors(self, *rows, codename="bookworm"):
        return debian.choose_mirrors("\n".join(rows), codename)

    def test_takes_the_release_and_not_its_security_archive(self):
        rows = [row("http://sec/", "bookworm-security"), row("http://deb/debian/", "bookworm"),
                row("http://deb/debian/", "bookworm-updates")]
        self.assertEqual(self.mirrors(*rows), ["http://deb/debian/"])

    def test_skips_others_sources(self):
        rows = [row("https://node/", "nodistro"), row("https://docker/", "bookworm", "stable"), row("http://deb/", "bookworm")]
        self.assertEqual(self.mirrors(*rows), ["http://deb/"])

    def test_the_source_with_updates_comes_first(self):
        rows = [row("https://a-tool/", "bookworm"), row("http://deb/", "bookworm"), row("http://deb/", "bookworm-updates")]
        self.assertEqual(self.mirrors(*rows), ["http://deb/", "https://a-tool/"])

    def test_a_machine_that_says_stable(self):
        self.assertEqual(self.mirrors(row("http://deb/", "stable")), ["http://deb/"])

    def test_ignores_what_is_no_package_list(self):
        text = "'http://deb/dists/bookworm/InRelease' deb_InRelease 0 \n'http://flat/Packages' flat 0 "
        self.assertEqual(self.mirrors(text), [])

    def test_nothing_configured(self):
        self.assertEqual(self.mirrors(""), [])


class Release(unittest.TestCase):
    def test_debian(self):
        self.assertEqual(debian.release_name('ID=debian\nVERSION_CODENAME=trixie\n'), "trixie")

    def test_quoted(self):
        self.assertEqual(debian.release_name('ID="debian"\nVERSION_CODENAME="forky"\n'), "forky")

    def test_another_distribution(self):
        self.assertIsNone(debian.release_name('ID=ubuntu\nID_LIKE=debian\nVERSION_CODENAME=noble\n'))


class Keys(unittest.TestCase):
    def test_the_keyring_named_beside_the_mirror(self):
        with tempfile.NamedTemporaryFile(suffix="debian-archive-keyring.pgp") as key:
            for text in (f"URIs: http://deb/debian\nSigned-By: {key.name}\n",
                         f"deb [arch=amd64 signed-by={key.name}] http://deb/debian x main\n"):
                self.assertEqual(debian.signing_key([text], "http://deb/debian/"), key.name)

    def test_not_the_keyring_of_another_source(self):
        with tempfile.NamedTemporaryFile(suffix=".gpg") as key:
            text = f"deb [signed-by={key.name}] https://node x main\n"
            self.assertNotEqual(debian.signing_key([text], "http://deb/debian/"), key.name)

    def test_a_named_file_that_is_not_there(self):
        found = debian.signing_key(["URIs: http://deb\nSigned-By: /no/such/key\n"], "http://deb/")
        self.assertIn(found, (None, debian.KEYRING))


if __name__ == "__main__":
    unittest.main()
