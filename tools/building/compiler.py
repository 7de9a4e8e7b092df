"""Compilers, flags and names: one SCons environment for each kind of source."""

import os
import platform
import sys

PLATFORMS = {"linux": "linux", "win32": "windows", "darwin": "macos"}
ARCHITECTURES = {"x86_64": "x86_64", "amd64": "x86_64", "aarch64": "arm64", "arm64": "arm64"}
PASSED_ON = ("PATH", "HOME", "TMPDIR", "TMP", "TEMP", "CPATH", "CPLUS_INCLUDE_PATH", "LIBRARY_PATH", "INCLUDE", "LIB",
             "SDKROOT", "PYTHONPATH", "GODOT", "DISPLAY", "WAYLAND_DISPLAY", "XAUTHORITY", "XDG_RUNTIME_DIR")

QUIET = {"CXX": "Compiling", "SHCXX": "Compiling", "AR": "Archiving", "RANLIB": "Indexing", "LINK": "Linking",
         "SHLINK": "Linking"}


def host_platform():
    return PLATFORMS.get(sys.platform, sys.platform)


def host_architecture():
    machine = platform.machine().lower()
    return ARCHITECTURES.get(machine, machine)


def is_msvc(env):
    return "msvc" in env["TOOLS"] and env.get("CC") == "cl"


def base_environment(make, arch, compiler, verbose):
    """What all sources share: C++17 and the machine's own tools. `make` is SCons' Environment."""
    target_arch = {"x86_64": "x86_64", "arm64": "arm64"}.get(arch)
    env = make(ENV={name: os.environ[name] for name in PASSED_ON if name in os.environ}, TARGET_ARCH=target_arch)
    if os.name == "nt":
        env["ENV"].update({name: os.environ[name] for name in ("SystemRoot", "PATHEXT") if name in os.environ})
    if not verbose:
        for tool, word in QUIET.items():
            env[tool + "COMSTR"] = word + " $TARGET"
    env.Replace(CXX=compiler or os.environ.get("CXX") or env["CXX"])
    if is_msvc(env):
        env.Append(CXXFLAGS=["/std:c++17", "/utf-8", "/EHsc", "/Zc:__cplusplus"], CPPDEFINES=["NOMINMAX"])
    else:
        env.Append(CXXFLAGS=["-std=c++17"], LINKFLAGS=["-pthread"])
        if host_platform() == "macos":
            env.Append(CCFLAGS=["-arch", arch], LINKFLAGS=["-arch", arch])
    for folder in ("/opt/homebrew/include", "/opt/local/include"):
        if host_platform() == "macos" and os.path.isdir(folder):
            env.Append(CCFLAGS=["-isystem", folder])
    return env


def for_library(env, release):
    """Code of the add-on's library: hidden symbols, and nothing that keeps the engine from unloading it."""
    env = env.Clone()
    if is_msvc(env):
        env.Append(CCFLAGS=["/MD"])
    else:
        env.Append(CCFLAGS=["-fPIC", "-fvisibility=hidden", "-fno-exceptions"])
        if "clang" not in env["CXX"] and host_platform() != "macos":
            # Unique symbols would keep the library in memory, and with it the code that a hot reload replaces.
            env.Append(CXXFLAGS=["-fno-gnu-unique"])
        if release and host_platform() == "linux":
            env.Append(LINKFLAGS=["-s"])
    if release:
        env.Append(CPPDEFINES=["NDEBUG"])
    return env


def strict(env):
    """All warnings, none let through: for our own sources."""
    env = env.Clone()
    env.Append(CCFLAGS=["/W4", "/WX"] if is_msvc(env) else ["-Wall", "-Wextra", "-Wshadow", "-Werror"])
    return env


def for_core(env, core_folder):
    """The engine-free core: sees itself and GLM only, and rounds as written on every machine."""
    env = strict(env)
    env.Replace(CPPPATH=[core_folder])
    env.Append(CCFLAGS=["/fp:precise"] if is_msvc(env) else ["-ffp-contract=off"])
    return env


def optimised(env, level):
    env = env.Clone()
    env.Append(CCFLAGS=["/O2"] if is_msvc(env) else [f"-O{level}"])
    return env


def for_kernels(env, file_name, arch):
    """The stepping kernels vectorise only where a square root need not set errno and comparisons need not trap."""
    env = env.Clone()
    if not is_msvc(env):
        env.Append(CCFLAGS=["-fno-math-errno", "-fno-trapping-math"])
    if "avx2" in file_name and arch == "x86_64":
        # Without FMA: a fused multiply rounds once and would give other bits than the portable kernel.
        env.Append(CCFLAGS=["/arch:AVX2"] if is_msvc(env) else ["-mavx2", "-mf16c", "-mno-fma"])
    return env


def use_godot_cpp(env, folder, platform, release):
    """Compiles against the built godot-cpp in `folder`, with the definitions that it was built with."""
    defines = ["GDEXTENSION", "THREADS_ENABLED"] + ([] if release else ["HOT_RELOAD_ENABLED", "DEBUG_ENABLED"])
    defines += {"linux": ["LINUX_ENABLED", "UNIX_ENABLED"], "macos": ["MACOS_ENABLED", "UNIX_ENABLED"],
                "windows": ["WINDOWS_ENABLED"]}.get(platform, [])
    env.Append(CPPDEFINES=defines)
    for name in ("include", "gen/include", "gdextension"):
        # As system headers: their warnings are not ours to mend.
        env.Append(CCFLAGS=["/I" if is_msvc(env) else "-isystem", f"{folder}/{name}"])


def use_bundled_binding(env, release):
    """Compiles against extension/binding and what was generated for it in build/binding."""
    env.Append(CPPDEFINES=[] if release else ["DEBUG_ENABLED", "HOT_RELOAD_ENABLED"])
    env.Append(CPPPATH=["#extension/binding/include", "#build/binding/include"])


def sanitized(env, kinds):
    """With the sanitizers of g++ and clang++; `kinds` as in -fsanitize=."""
    env = env.Clone()
    flags = [f"-fsanitize={kinds}", "-fno-omit-frame-pointer", "-g1"]
    env.Append(CCFLAGS=[*flags, "-O1", "-fno-sanitize-recover=all"], LINKFLAGS=flags)
    return env
