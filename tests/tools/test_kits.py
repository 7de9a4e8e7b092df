"""Builds for phones and universal libraries for Macs: the commands of a dry run with kits that contain no compiler."""

import os
import shlex
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))

from building import compiler, kits
from dry_run import dry_run, make_checkout
from shipping import archive

XCRUN = "#!/bin/sh\necho /SDK/iPhoneOS.sdk\n"


def write_program(path, text="#!/bin/sh\nexit 1\n"):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text)
    path.chmod(0o755)


def make_ndk(folder, release=28):
    (folder / "toolchains/llvm/prebuilt/linux-x86_64/bin").mkdir(parents=True)
    (folder / "source.properties").write_text(f"Pkg.Desc = Android NDK\nPkg.Revision = {release}.0.13004108\n")
    return folder


@unittest.skipUnless(os.name == "posix", "the kits here are shell scripts")
class Kits(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name).resolve()
        write_program(self.folder / "kit/xcrun", XCRUN)

    def scons(self, *words, **environment):
        """(exit status, output) of a dry run with the real SConstruct, in a checkout of its own."""
        checkout = self.folder / "checkout"
        if not checkout.exists():
            make_checkout(checkout)
        unset = {"ANDROID_NDK_ROOT"} - set(environment)
        return dry_run(checkout, f"godot_cpp={self.folder}", *words, without=unset, PATH=[self.folder / "kit"],
                       PYTHONDONTWRITEBYTECODE="1", **environment)

    def commands(self, platform, arch, kind="debug", **environment):
        """(commands that compile by file, command that links) of the library for `platform` and `arch`."""
        godot_cpp = self.folder / f"bin/libgodot-cpp.{platform}.template_{kind}.{arch}.a"
        godot_cpp.parent.mkdir(exist_ok=True)
        godot_cpp.touch()
        status, output = self.scons(f"platform={platform}", f"arch={arch}", f"target=template_{kind}", "build", **environment)
        self.assertEqual(status, 0, output[-2000:])
        lines = [shlex.split(line) for line in output.splitlines() if " -o " in line]
        compiled = {Path(line[-1]).name: line for line in lines if "-c" in line}
        linked = [line for line in lines if "-c" not in line]
        self.assertEqual(len(linked), 1, output[-2000:])
        self.assertGreater(len(compiled), 100)
        name = f"libundergrowth.{platform}.template_{kind}.{arch}"
        self.assertEqual(Path(linked[0][linked[0].index("-o") + 1]).name, name + (".so" if platform == "android" else ".dylib"))
        return compiled, linked[0]

    def check_target(self, compiled, linked, target):
        for line in [*compiled.values(), linked]:
            self.assertEqual(line[line.index("-target") + 1], target)

    def test_android(self):
        ndk = make_ndk(self.folder / "ndk")
        for arch, processor in (("arm64", "aarch64"), ("x86_64", "x86_64")):
            compiled, linked = self.commands("android", arch, ANDROID_NDK_ROOT=str(ndk))
            self.check_target(compiled, linked, f"{processor}-linux-android24")
            self.assertTrue(all(Path(line[0]).is_relative_to(ndk) for line in [*compiled.values(), linked]))
            for flag in ("-shared", "-Wl,-z,max-page-size=16384", "-static-libstdc++"):
                self.assertIn(flag, linked)
            self.assertTrue(any("--version-script=" in word for word in linked))
            self.assertIn("-DANDROID_ENABLED", compiled["register_types.cpp"])
            with_avx = {name for name, line in compiled.items() if any("avx" in word for word in line if word.startswith("-m"))}
            self.assertEqual(with_avx, set() if arch == "arm64" else {name for name in compiled if "avx2" in name})

    def test_ios(self):
        compiled, linked = self.commands("ios", "arm64", "release")
        self.check_target(compiled, linked, "arm64-apple-ios14.0")
        for line in [*compiled.values(), linked]:
            self.assertEqual(line[1:4], ["--sdk", "iphoneos", "clang++"])
            self.assertEqual(line[line.index("-isysroot") + 1], "/SDK/iPhoneOS.sdk")
            self.assertFalse([word for word in line if word.startswith("-mavx")])
        self.assertIn("-shared", linked)
        self.assertIn("-Wl,-install_name,@rpath/libundergrowth.ios.template_release.arm64.dylib", linked)

    def test_universal_library_has_flags_for_one_processor_each(self):
        env = Words(TOOLS=[], ZIG="", CXX="clang++", TARGET_PLATFORM="macos")
        compiler.use_apple(env, "universal")
        self.assertEqual(env["LINKFLAGS"], ["-arch", "x86_64", "-arch", "arm64"])
        flags = compiler.for_kernels(env, "kernels_avx2.cpp", "universal")["CCFLAGS"]
        self.assertEqual(flags[flags.index("-mavx2") - 1], "-Xarch_x86_64")

    def test_without_a_kit_one_error_says_what_to_install(self):
        old = make_ndk(self.folder / "old", release=27)
        (self.folder / "kit/xcrun").unlink()
        for words, text in ((("android", "arm64", ""), "ANDROID_NDK_ROOT is not set"),
                            (("android", "arm64", str(self.folder)), "contains no NDK"),
                            (("android", "arm64", str(old)), "is older than release 28"),
                            (("ios", "arm64", ""), "xcrun is not on PATH"),
                            (("ios", "x86_64", ""), "no library for platform=ios arch=x86_64. Use arch=arm64."),
                            (("linux", "wasm32", ""), "no library for platform=linux arch=wasm32")):
            status, output = self.scons(f"platform={words[0]}", f"arch={words[1]}", "build", ANDROID_NDK_ROOT=words[2])
            self.assertEqual((status, len(output.splitlines())), (2, 1), output)
            self.assertIn(text, output)

    def test_libraries_of_phones_are_listed_by_the_names_that_builds_give(self):
        text = (ROOT / archive.LIST).read_text(encoding="utf-8")
        for platform, suffix in (("android", "so"), ("ios", "dylib")):
            lines = [f'{platform}.{kind}.{arch} = "bin/libundergrowth.{platform}.template_{kind}.{arch}.{suffix}"'
                     for arch in kits.PROCESSORS[platform] for kind in ("debug", "release")]
            self.assertEqual([line for line in text.splitlines() if line.startswith(platform)], lines)


class Words(dict):
    """What compiler.py uses of an environment of SCons."""

    def Clone(self):  # noqa: N802  (SCons' name)
        return Words({name: list(value) if isinstance(value, list) else value for name, value in self.items()})

    def Append(self, **words):  # noqa: N802
        for name, value in words.items():
            self[name] = self.get(name, []) + value


if __name__ == "__main__":
    unittest.main()
