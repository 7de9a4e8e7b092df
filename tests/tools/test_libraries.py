"""Every error of a library is reported before it ships."""

import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))

from shipping import checks, universal
from shipping.library import Unreadable
from small_libraries import ENTRY, elf, macho, pe

SYSTEMS = {"linux": (elf, "x86_64"), "windows": (pe, "x86_64"), "macos": (macho, "arm64")}
PATH = "/home/somebody/undergrowth/"
LIPO = next(filter(None, map(shutil.which, ("llvm-lipo", "llvm-lipo-14", "lipo"))), None)


def parts(**options):
    """A library of macOS for each processor; `options` are those of the one for arm64."""
    return {"arm64": macho(**options), "x86_64": macho(machine=0x01000007, oldest=(10, 15), is_signed=False)}


def wrong(data, platform, arch=None, **options):
    return checks.complaints(data, platform, arch or SYSTEMS[platform][1], "lib.dylib", [PATH], **options)


class Libraries(unittest.TestCase):
    def assert_reported(self, sentence, data, platform, arch=None):
        found = wrong(data, platform, arch)
        self.assertEqual(len(found), 1, found)
        self.assertRegex(found[0], sentence)

    def test_sound_ones_pass(self):
        for platform, (make, _) in SYSTEMS.items():
            self.assertEqual(wrong(make(), platform), [], platform)
        self.assertEqual(wrong(elf(machine=183), "linux", "arm64"), [])
        self.assertEqual(wrong(pe(machine=0xAA64), "windows", "arm64"), [])
        self.assertEqual(wrong(macho(machine=0x01000007, oldest=(10, 15), is_signed=False), "macos", "x86_64"), [])

    def test_what_is_no_library_or_half_of_one(self):
        for platform, (make, _) in SYSTEMS.items():
            self.assert_reported("it is no library", b"", platform)
            self.assert_reported("broken library", make()[:100], platform)

    def test_of_another_machine_or_system(self):
        for platform, (make, arch) in SYSTEMS.items():
            other = "arm64" if arch == "x86_64" else "x86_64"
            self.assert_reported(f"it is for {platform} on {arch}", make(), platform, other)
            self.assert_reported("another machine", make(machine=7), platform)
        self.assert_reported("it is for linux", elf(), "windows")

    def test_without_an_entry_or_with_more(self):
        for platform, (make, _) in SYSTEMS.items():
            self.assertRegex(wrong(make(exports=("other",)), platform)[0], f"does not export {ENTRY}")
            self.assert_reported(f"exports more than {ENTRY}: other", make(exports=(ENTRY, "other")), platform)

    def test_memory_is_shown_on_macos_only(self):
        self.assertEqual(wrong(macho(exports=(ENTRY, "_Znwm", "_ZdlPvSt11align_val_t")), "macos"), [])
        self.assert_reported("exports more", elf(exports=(ENTRY, "_Znwm")), "linux")

    def test_with_libraries_that_a_system_may_lack(self):
        self.assert_reported(r"may lack: libstdc\+\+", elf(needs=("libc.so.6", "libstdc++.so.6")), "linux")
        self.assert_reported("may lack: libwinpthread", pe(needs=("KERNEL32.dll", "libwinpthread-1.dll")), "windows")
        self.assert_reported("may lack: /opt/homebrew", macho(needs=("/opt/homebrew/lib/libglm.dylib",)), "macos")

    def test_for_newer_systems(self):
        self.assert_reported("GLIBC_2.34, newer than glibc 2.28", elf(versions=("GLIBC_2.17", "GLIBC_2.34")), "linux")
        self.assert_reported("GLIBCXX_3.4.29", elf(versions=("GLIBCXX_3.4.29",)), "linux")
        self.assert_reported("macOS 13.0, newer than 11.0", macho(oldest=(13, 0)), "macos")

    def test_that_leaves_its_destructors_to_the_end_of_the_engine(self):
        self.assert_reported("__cxa_finalize", elf(imports=("malloc",)), "linux")

    def test_unsigned_or_changed_after_it_was_signed(self):
        self.assert_reported("signature does not hold: it has none", macho(is_signed=False), "macos")
        signed = macho(extra=b"text")
        self.assert_reported("page 0 is not what was signed", signed.replace(b"text", b"next"), "macos")

    def test_with_symbols_that_lead_nowhere(self):
        self.assert_reported("1 of its indirect symbols", macho(indirect=(0, 5000)), "macos")

    def test_that_calls_itself_by_a_path(self):
        self.assert_reported("calls itself build/lib.dylib", macho(name="build/lib.dylib"), "macos")

    def test_with_a_path_of_the_machine_that_built_it(self):
        for platform, (make, _) in SYSTEMS.items():
            self.assert_reported("path of the machine", make(extra=PATH.encode() + b"glm.hpp\0"), platform)

    def test_for_this_machine_alone_it_may_need_what_that_has(self):
        data = elf(needs=("libstdc++.so.6",), versions=("GLIBC_2.38",), imports=())
        self.assertEqual(wrong(data, "linux", is_for_all=False), [])


class UniversalLibraries(unittest.TestCase):
    def assert_reported(self, sentence, data):
        found = wrong(data, "macos", "universal")
        self.assertEqual(len(found), 1, found)
        self.assertRegex(found[0], sentence)

    def test_parts_are_those_that_were_joined(self):
        data = universal.join(parts(extra=b"text"))
        self.assertEqual(universal.split(data), parts(extra=b"text"))
        self.assertEqual(wrong(data, "macos", "universal"), [])

    @unittest.skipUnless(LIPO, "no lipo is on PATH")
    def test_bytes_are_those_of_lipo(self):
        with tempfile.TemporaryDirectory() as folder:
            paths = []
            for name, data in parts(extra=bytes(5000)).items():
                paths.append(Path(folder, name))
                paths[-1].write_bytes(data)
            subprocess.run([LIPO, "-create", *paths, "-output", Path(folder, "both")], check=True)
            listed = subprocess.run([LIPO, "-archs", Path(folder, "both")], check=True, capture_output=True, text=True)
            self.assertEqual(listed.stdout.split(), ["x86_64", "arm64"])
            theirs, ours = Path(folder, "both").read_bytes(), universal.join(parts(extra=bytes(5000)))
            self.assertEqual(theirs, ours)

    def test_each_part_is_checked(self):
        self.assert_reported("for arm64 its signature does not hold", universal.join(parts(is_signed=False)))
        self.assert_reported("for arm64 it holds a path", universal.join(parts(extra=PATH.encode())))

    def test_of_one_processor_or_none(self):
        self.assert_reported("it is no universal library", macho())
        self.assert_reported("it is for arm64", universal.join({"arm64": macho()}))
        self.assert_reported("it is for no processor", universal.join({}))

    def test_half_of_one(self):
        data = universal.join(parts())
        self.assert_reported("its part for arm64 ends behind it", data[:-1])
        self.assert_reported("broken library", data[:20])

    def test_a_part_begins_with_a_page(self):
        data = bytearray(universal.join(parts()) + bytes(8))
        data[8 + 20 + 11] += 4  # The low byte of the offset of the part for arm64.
        with self.assertRaisesRegex(Unreadable, "part for arm64 begins within a page"):
            universal.split(bytes(data))


if __name__ == "__main__":
    unittest.main()
