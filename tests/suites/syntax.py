"""Sources for phones and browsers, as far as they can be read without the kits: zig's clang reads each of them for the
target, with all warnings, the headers of its libc++, and those of a similar system's C library. Nothing is linked.

A plain test does not run it: `./run test suites=syntax`, `only=android-arm64` for one target.
"""

import concurrent.futures
import os
import subprocess
from dataclasses import dataclass

from building import compiler, kits, sources
from toolchain import headers, zig
from toolchain.place import Missing

from .result import LOGS, ROOT, Result

FOLDERS = ("extension/core", "extension/godot", "extension/binding/src", "build/binding")
FLAGS = ["-std=c++17", "-fsyntax-only", "-fno-exceptions", "-Wall", "-Wextra", "-Wshadow", "-Werror", "-nostdinc"]
# What the file __config_site of a libc++ defines; zig defines it for each target.
LIBCXX = {
    "ABI_NAMESPACE": "__1", "ABI_VERSION": 1, "ASSERTION_SEMANTIC_DEFAULT": "_LIBCPP_ASSERTION_SEMANTIC_IGNORE",
    "DISABLE_VISIBILITY_ANNOTATIONS": "", "HARDENING_MODE_DEFAULT": "_LIBCPP_HARDENING_MODE_NONE", "HAS_FILESYSTEM": 1,
    "HAS_LOCALIZATION": 1, "HAS_MONOTONIC_CLOCK": 1, "HAS_RANDOM_DEVICE": 1, "HAS_TERMINAL": 1, "HAS_THREADS": 1,
    "HAS_TIME_ZONE_DATABASE": 0, "HAS_UNICODE": 1, "HAS_VENDOR_AVAILABILITY_ANNOTATIONS": 0, "HAS_WIDE_CHARACTERS": 1,
    "PSTL_BACKEND_SERIAL": "",
}
TIMEOUT = 120  # s, of one file.


@dataclass
class Target:
    """`words` name the processor and the system. `system` is the folders of zig's headers for it."""

    arch: str
    words: list
    system: tuple
    has_musl: bool = True


# bionic and Emscripten's C library are like musl. zig has no clang for wasm32-emscripten, but WASI has its sizes.
TARGETS = {
    "android-arm64": Target("arm64", ["--target=" + kits.ANDROID_TARGETS["arm64"]], ("aarch64-linux-musl", "generic-musl")),
    "android-x86_64": Target("x86_64", ["--target=" + kits.ANDROID_TARGETS["x86_64"]], ("x86_64-linux-musl", "generic-musl")),
    "ios-arm64": Target("arm64", ["--target=" + kits.IOS_TARGETS["arm64"]], ("any-darwin-any",), has_musl=False),
    "web-wasm32": Target("wasm32", ["--target=wasm32-wasip1-threads", "-pthread", "-msimd128"],
                         ("wasm-wasi-musl", "generic-musl")),
}


def suites(only):
    names = [name for name in TARGETS if not only or name in only.split(",")]
    return [("syntax:" + name, lambda name=name: read_all(name)) for name in names]


def read_all(name):
    """One test for each source that the compiler reads without a word."""
    try:
        program = zig.fetch()
        glm = headers.private_folder()
    except Missing as missing:
        return Result("syntax:" + name, 0, [str(missing).replace("\n", " ")])
    paths = sources.cpp_files(ROOT, *FOLDERS)
    with concurrent.futures.ThreadPoolExecutor(max_workers=os.cpu_count()) as pool:
        said = dict(zip(paths, pool.map(lambda path: read(words_for(program, glm, TARGETS[name], path)), paths)))
    (LOGS / f"syntax-{name}.log").write_text("".join(said.values()), encoding="utf-8")
    failures = [f"{path}: {first_error(text)}" for path, text in said.items() if text]
    return Result("syntax:" + name, len(paths) - len(failures), failures)


def words_for(program, glm, target, path):
    """The call of the compiler for the source at `path`."""
    library = program.parent / "lib"
    own = ["-I" + folder for folder in ("extension/core", *(() if path.startswith("extension/core/") else (
        "extension/godot", "extension/binding/include", "build/binding/include")))]
    found = [library / name for name in ("libcxx/include", "libcxxabi/include", "include")]
    found += [library / "libc/include" / name for name in target.system] + [glm]
    defines = [f"-D_LIBCPP_{name}={value}" for name, value in {**LIBCXX, "HAS_MUSL_LIBC": int(target.has_musl)}.items()]
    vectors = compiler.AVX2_FLAGS if "avx2" in path and target.arch == "x86_64" else []
    return [program, "clang", *target.words, *FLAGS, *vectors, *defines, *own,
            *(word for folder in found for word in ("-isystem", folder)), path]


def read(words):
    """What the compiler says of a source; empty where it accepts it."""
    try:
        done = subprocess.run(list(map(str, words)), cwd=ROOT, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True, timeout=TIMEOUT)
    except subprocess.TimeoutExpired:
        return f"error: not read after {TIMEOUT} s\n"
    return done.stdout or ("" if done.returncode == 0 else f"error: status {done.returncode}\n")


def first_error(text):
    return next((line for line in text.splitlines() if "error:" in line), text.splitlines()[0])
