"""Compilers, flags and names: one SCons environment for each kind of source.

What is compiled for is the target's platform and processor, which `zig c++` makes different from this machine's.
"""

import os
import platform
import sys

from . import kits

PLATFORMS = {"linux": "linux", "win32": "windows", "darwin": "macos"}
ARCHITECTURES = {"x86_64": "x86_64", "amd64": "x86_64", "aarch64": "arm64", "arm64": "arm64"}
PASSED_ON = ("PATH", "HOME", "TMPDIR", "TMP", "TEMP", "CPATH", "CPLUS_INCLUDE_PATH", "LIBRARY_PATH", "INCLUDE", "LIB",
             "SDKROOT", "PYTHONPATH", "GODOT", "DISPLAY", "WAYLAND_DISPLAY", "XAUTHORITY", "XDG_RUNTIME_DIR")

# What `zig c++` compiles for: the oldest systems that Godot 4.6 itself runs on.
ZIG_TARGETS = {
    ("linux", "x86_64"): "x86_64-linux-gnu.2.28", ("linux", "arm64"): "aarch64-linux-gnu.2.28",
    ("windows", "x86_64"): "x86_64-windows-gnu", ("windows", "arm64"): "aarch64-windows-gnu",
    ("macos", "x86_64"): "x86_64-macos.10.15", ("macos", "arm64"): "aarch64-macos.11.0",
}
ZIG_TOOLS = ["gcc", "g++", "gnulink", "ar"]
# Emscripten's programs, and what they need for a library that the engine loads, as in godot-cpp.
WEB_PROGRAMS = {"CXX": "em++", "LINK": "em++", "SHLINK": "em++", "AR": "emar", "RANLIB": "emranlib"}
WEB_FLAGS = ["-sSIDE_MODULE=1", "-sSUPPORT_LONGJMP=wasm"]
LIBRARY_SUFFIXES = {"linux": ".so", "windows": ".dll", "macos": ".dylib"}
MAC_PROCESSORS = ["x86_64", "arm64"]
# Without FMA: a fused multiply rounds once and would give other bits than the portable kernel.
AVX2_FLAGS = ["-mavx2", "-mf16c", "-mno-fma"]
ZIG_CACHES = ("ZIG_GLOBAL_CACHE_DIR", "ZIG_LOCAL_CACHE_DIR")

QUIET = {"CXX": "Compiling", "SHCXX": "Compiling", "AR": "Archiving", "RANLIB": "Indexing", "LINK": "Linking",
         "SHLINK": "Linking"}


def host_platform():
    return PLATFORMS.get(sys.platform, sys.platform)


def host_architecture():
    """On a Mac one library is for both processors, as the .gdextension file lists it."""
    if sys.platform == "darwin":
        return "universal"
    machine = platform.machine().lower()
    return ARCHITECTURES.get(machine, machine)


def is_msvc(env):
    return "msvc" in env["TOOLS"] and env.get("CC") == "cl"


def base_environment(make, settings):
    """What all sources share: C++17 and the machine's own tools, or zig's. `make` is SCons' Environment."""
    arch, platform_name, zig = settings["arch"], settings["platform"], settings["zig"]
    tools = {"tools": ZIG_TOOLS} if zig or platform_name in kits.LIBRARY_ONLY else {"TARGET_ARCH": arch}
    env = make(ENV={name: os.environ[name] for name in PASSED_ON if name in os.environ}, TARGET_PLATFORM=platform_name,
               ZIG=zig, **tools)
    if os.name == "nt":
        env["ENV"].update({name: os.environ[name] for name in ("SystemRoot", "PATHEXT") if name in os.environ})
    if not settings["verbose"]:
        for tool, word in QUIET.items():
            env[tool + "COMSTR"] = word + " $TARGET"
    if zig:
        use_zig(env, settings["ROOT"], platform_name, arch)
    elif platform_name == "web":
        use_emscripten(env, settings["ROOT"], settings["threads"])
    elif platform_name in kits.PHONES:
        kits.use(env, settings["KIT"], settings["ROOT"], platform_name, arch)
    else:
        env.Replace(CXX=settings["cxx"] or os.environ.get("CXX") or env["CXX"])
    if is_msvc(env):
        env.Append(CXXFLAGS=["/std:c++17", "/utf-8", "/EHsc", "/Zc:__cplusplus"], CPPDEFINES=["NOMINMAX"])
    else:
        env.Append(CXXFLAGS=["-std=c++17"], LINKFLAGS=["-pthread"] if settings["threads"] else [])
        if platform_name == "macos" and not zig:
            use_apple(env, arch)
    return env


def use_emscripten(env, root, with_threads):
    """Emscripten from PATH: the version that built the engine's export templates."""
    env.Replace(SHLIBSUFFIX=".wasm", SHOBJSUFFIX=".pic.o", **WEB_PROGRAMS)
    env.Append(CCFLAGS=[*WEB_FLAGS, "-msimd128", f"-ffile-prefix-map={root}={os.curdir}"],
               LINKFLAGS=[*WEB_FLAGS, "-sWASM_BIGINT"])
    env["ENV"].update({name: value for name, value in os.environ.items() if name.startswith(("EM_", "EMSDK", "EMCC"))})
    if with_threads:
        env.Append(CCFLAGS=["-pthread"])


def use_apple(env, arch):
    """The compiler of a Mac, and where its package managers put headers."""
    words = [word for name in (MAC_PROCESSORS if arch == "universal" else [arch]) for word in ("-arch", name)]
    env.Append(CCFLAGS=words, LINKFLAGS=words)
    for folder in ("/opt/homebrew/include", "/opt/local/include"):
        if os.path.isdir(folder):
            env.Append(CCFLAGS=["-isystem", folder])


def use_zig(env, root, platform_name, arch):
    """`zig c++` for a platform and a processor. It does not use this machine's headers and libraries."""
    words = [env["ZIG"], "c++", "-target", ZIG_TARGETS[platform_name, arch]]
    env.Replace(CXX=words, LINK=words, AR=[env["ZIG"], "ar"], RANLIB=[env["ZIG"], "ranlib"],
                SHLIBSUFFIX=LIBRARY_SUFFIXES[platform_name], PROGSUFFIX=".exe" if platform_name == "windows" else "",
                SHOBJSUFFIX=".pic.o")  # It does not take .os for an object.
    # Without -O it would compile UBSan in; and no path of this machine goes into a library.
    env.Append(CCFLAGS=["-fno-sanitize=undefined", f"-ffile-prefix-map={root}={os.curdir}"])
    for folder in os.environ.get("CPLUS_INCLUDE_PATH", "").split(os.pathsep):
        env.Append(CCFLAGS=["-isystem", folder] if folder else [])
    for name in ZIG_CACHES:
        env["ENV"][name] = os.path.join(root, "build", "zig", name.split("_")[1].lower())


def uses_gcc(env):
    others = ("macos", *kits.LIBRARY_ONLY)
    return not is_msvc(env) and not env["ZIG"] and "clang" not in env["CXX"] and env["TARGET_PLATFORM"] not in others


def for_library(env, with_asserts):
    """Code of the add-on's library: hidden symbols, and nothing that prevents the engine from unloading it."""
    env = env.Clone()
    if is_msvc(env):
        env.Append(CCFLAGS=["/MD"])
    else:
        env.Append(CCFLAGS=["-fPIC", "-fvisibility=hidden", "-fno-exceptions"])
    if uses_gcc(env):
        # Unique symbols prevent unloading, so a hot reload would continue to run the old code.
        env.Append(CXXFLAGS=["-fno-gnu-unique"])
    if not with_asserts:
        env.Append(CPPDEFINES=["NDEBUG"])
    return env


def library_link_flags(env, name, release, import_library):
    """How the library `name` is linked. `import_library` is the unused import library of Windows' linker."""
    if is_msvc(env):
        return []
    if env["TARGET_PLATFORM"] == "linux":
        # zig's own libraries contain 40 MB of debug information.
        return ["-s"] if release else ["-Wl,--strip-debug"] if env["ZIG"] else []
    if env["TARGET_PLATFORM"] in kits.PHONES:
        return kits.link_flags(env["TARGET_PLATFORM"], name, release)
    if not env["ZIG"]:
        return []
    if env["TARGET_PLATFORM"] == "macos":
        # Not -x: with that zig 0.17 writes indirect symbols that lead into the code.
        return ["-Wl,-dead_strip", "-s", f"-Wl,-install_name,@rpath/{of_both(name)}"]
    return ["-s", f"-Wl,--out-implib,{import_library}"]


def of_both(name):
    """The name of the universal library with the library `name` in it."""
    for processor in MAC_PROCESSORS:
        name = name.replace(f".{processor}.", ".universal.")
    return name


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
    if "avx2" in file_name and arch in ("x86_64", "universal"):
        flags = ["/arch:AVX2"] if is_msvc(env) else AVX2_FLAGS
        # A universal object has its flags for one processor only.
        env.Append(CCFLAGS=[word for flag in flags for word in ("-Xarch_x86_64", flag)] if arch == "universal" else flags)
    return env


def library_suffix(platform, kind, arch, with_threads=True):
    """What the names of libraries and objects end in, before the file's type; as godot-cpp."""
    return f"{platform}.{kind}.{arch}" + ("" if with_threads else ".nothreads")


def library_name(platform_name, kind, arch):
    """The file of the add-on's library on a desktop."""
    return f"libundergrowth.{library_suffix(platform_name, kind, arch)}{LIBRARY_SUFFIXES[platform_name]}"


def use_godot_cpp(env, folder, platform, release, with_threads=True):
    """Compiles against the built godot-cpp in `folder`, with the definitions that it was built with."""
    defines = ["GDEXTENSION"] + (["THREADS_ENABLED"] if with_threads else []) + ([] if release else ["HOT_RELOAD_ENABLED", "DEBUG_ENABLED"])
    defines += {"linux": ["LINUX_ENABLED", "UNIX_ENABLED"], "macos": ["MACOS_ENABLED", "UNIX_ENABLED"],
                "windows": ["WINDOWS_ENABLED"], "web": ["WEB_ENABLED", "UNIX_ENABLED"],
                "android": ["ANDROID_ENABLED", "UNIX_ENABLED"], "ios": ["IOS_ENABLED", "UNIX_ENABLED"]}.get(platform, [])
    env.Append(CPPDEFINES=defines)
    for name in ("include", "gen/include", "gdextension"):
        # As system headers: their warnings are not ours to mend.
        env.Append(CCFLAGS=["/I" if is_msvc(env) else "-isystem", f"{folder}/{name}"])


def use_bundled_binding(env):
    """Compiles against extension/binding and what was generated for it in build/binding."""
    env.Append(CPPPATH=["#extension/binding/include", "#build/binding/include"])


def sanitized(env, kinds):
    """With the sanitizers of g++ and clang++; `kinds` as in -fsanitize=."""
    env = env.Clone()
    flags = [f"-fsanitize={kinds}", "-fno-omit-frame-pointer", "-g1"]
    env.Append(CCFLAGS=[*flags, "-O1", "-fno-sanitize-recover=all"], LINKFLAGS=flags)
    return env
