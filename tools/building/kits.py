"""The compilers of phones, where they are installed: Android's NDK, and Xcode for iOS."""

import os
import re
import shutil
import subprocess

# What each platform runs on. Names are those of the .gdextension file.
PROCESSORS = {
    "linux": ("x86_64", "arm64"), "windows": ("x86_64", "arm64"), "macos": ("x86_64", "arm64", "universal"),
    "web": ("wasm32",), "android": ("arm64", "x86_64"), "ios": ("arm64",),
}
PHONES = ("android", "ios")
# Platforms whose libraries are built, and no programs that run here.
LIBRARY_ONLY = ("web", *PHONES)

OLDEST_NDK = 28
# The oldest systems that Godot 4.6 itself runs on.
ANDROID_API = 24
IOS_VERSION = "14.0"
ANDROID_TARGETS = {"arm64": f"aarch64-linux-android{ANDROID_API}", "x86_64": f"x86_64-linux-android{ANDROID_API}"}
IOS_TARGETS = {"arm64": f"arm64-apple-ios{IOS_VERSION}"}
# Devices with pages of 16 KiB load no library that is aligned to 4 KiB.
ANDROID_LINK_FLAGS = ["-Wl,-z,max-page-size=16384", "-Wl,--no-undefined", "-static-libstdc++"]
NDK_HOSTS = {"posix": ("linux-x86_64", "darwin-x86_64"), "nt": ("windows-x86_64",)}
NDK_REVISION = re.compile(r"^Pkg\.Revision\s*=\s*(\d+)", re.MULTILINE)


class KitError(Exception):
    """The kit of a platform is missing or too old. The text says what to install."""


def check_processor(platform, arch):
    """Raises KitError where `platform` has no library for `arch`."""
    known = PROCESSORS.get(platform, (arch,))
    if arch not in known:
        raise KitError(f"Undergrowth has no library for platform={platform} arch={arch}. Use "
                       + " or ".join(f"arch={name}" for name in known) + ".")


def find(platform, environment=os.environ):
    """{variable of SCons: words} of the programs of the kit for `platform`; empty for all but phones."""
    return {"android": find_ndk, "ios": find_xcode}.get(platform, lambda _: {})(environment)


def find_ndk(environment):
    root = environment.get("ANDROID_NDK_ROOT", "")
    advice = f"Install Android's NDK, release {OLDEST_NDK} or newer, and set ANDROID_NDK_ROOT to its folder."
    try:
        with open(os.path.join(root, "source.properties"), encoding="utf-8") as file:
            revision = NDK_REVISION.search(file.read())
    except OSError:
        place = f"{root} contains no NDK" if root else "ANDROID_NDK_ROOT is not set"
        raise KitError(f"platform=android: {place}. {advice}") from None
    if not revision or int(revision.group(1)) < OLDEST_NDK:
        raise KitError(f"platform=android: the NDK in {root} is older than release {OLDEST_NDK}. {advice}")
    for host in NDK_HOSTS[os.name]:
        folder = os.path.join(root, "toolchains/llvm/prebuilt", host, "bin")
        if os.path.isdir(folder):
            return programs(lambda name: [os.path.join(folder, name + (".exe" if os.name == "nt" else ""))])
    raise KitError(f"platform=android: the NDK in {root} has no compiler for this machine. {advice}")


def find_xcode(environment):
    advice = "Install Xcode on a Mac, and select it by `xcode-select --switch`."
    program = shutil.which("xcrun", path=environment.get("PATH", ""))
    if not program:
        raise KitError(f"platform=ios: xcrun is not on PATH. {advice}")
    asked = subprocess.run([program, "--sdk", "iphoneos", "--show-sdk-path"], capture_output=True, text=True)
    sdk = asked.stdout.strip()
    if asked.returncode != 0 or not sdk:
        raise KitError(f"platform=ios: xcrun finds no SDK for iOS. {advice}")
    found = programs(lambda name: [program, "--sdk", "iphoneos", name.removeprefix("llvm-")])
    return {**found, "SDK": ["-isysroot", sdk]}


def programs(words_of):
    """The programs of LLVM by SCons' names."""
    compiler = words_of("clang++")
    return {"CXX": compiler, "LINK": compiler, "SHLINK": compiler, "AR": words_of("llvm-ar"), "RANLIB": words_of("llvm-ranlib")}


def use(env, kit, root, platform, arch):
    """Compiles with the programs of `kit`. No path of this machine goes into a library."""
    kit = dict(kit)
    sdk = kit.pop("SDK", [])
    is_android = platform == "android"
    target = ["-target", (ANDROID_TARGETS if is_android else IOS_TARGETS)[arch], *sdk]
    env.Replace(SHLIBSUFFIX=".so" if is_android else ".dylib", SHOBJSUFFIX=".pic.o", **kit)
    env.Append(CCFLAGS=[*target, f"-ffile-prefix-map={root}={os.curdir}"],
               LINKFLAGS=[*target, *(ANDROID_LINK_FLAGS if is_android else [])])
    # These compilers do not use this machine's headers, but GLM's folder.
    for name in ("CPATH", "LIBRARY_PATH", "SDKROOT"):
        env["ENV"].pop(name, None)
    for folder in env["ENV"].pop("CPLUS_INCLUDE_PATH", "").split(os.pathsep):
        env.Append(CCFLAGS=["-isystem", folder] if folder else [])


def link_flags(platform, name, release):
    """How the library `name` of a phone is linked."""
    if platform == "android":
        return [f"-Wl,-soname,{name}", *(["-s"] if release else [])]
    return [f"-Wl,-install_name,@rpath/{name}", "-Wl,-dead_strip", *(["-Wl,-x"] if release else [])]
