"""godot-cpp: which one the library is compiled against, if any, and how the submodule is built for that."""

import json
import os
import subprocess

SUBMODULE = "godot-cpp"
BUNDLED = "no"
# Words that read what the bundled binding leaves in build, or build for other systems.
BUNDLED_WORDS = {"versions", "package"}
PROFILE = "build/godot_cpp_profile.json"
# godot-cpp omits methods whose signatures name a class that is not in the profile.
IN_SIGNATURES = ["ScriptBacktrace"]


class NotInitialised(Exception):
    """The submodule is an empty folder. The text says what to do."""


def library(folder, suffix, platform):
    """The path of a built godot-cpp; `suffix` as compiler.library_suffix."""
    return os.path.join(folder, "bin", f"libgodot-cpp.{suffix}{'.lib' if platform == 'windows' else '.a'}")


def chosen(root, named, suffixes, platform, is_own_compiler, words):
    """The folder of the godot-cpp to compile against; "" for the bundled binding.

    `named` is the option godot_cpp. Without it this is the submodule, if it is built for all `suffixes` by the compiler that
    compiles the library.
    """
    if named:
        return "" if named == BUNDLED else os.path.abspath(named)
    folder = os.path.join(root, SUBMODULE)
    fits = is_own_compiler and len(suffixes) == 1 and not set(words) & BUNDLED_WORDS
    return folder if fits and all(os.path.isfile(library(folder, suffix, platform)) for suffix in suffixes) else ""


def write_profile(root, names):
    """Writes the engine classes that the library uses, `names`, as a build profile. Returns its path."""
    path = os.path.join(root, PROFILE)
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w", encoding="utf-8") as file:
        json.dump({"enabled_classes": names + IN_SIGNATURES}, file, indent="\t")
    return path


def words_for(api, profile, platform, arch, kind, threads, jobs):
    """The options of godot-cpp's own SConstruct. Definitions are those of compiler.use_godot_cpp()."""
    return [f"platform={platform}", f"arch={arch}", f"target={kind}", f"threads={'yes' if threads else 'no'}",
            f"custom_api_file={api}", f"build_profile={profile}", "debug_symbols=no",
            f"use_hot_reload={'no' if kind == 'template_release' else 'yes'}", f"-j{jobs}"]


def build(command, root, words, environment):
    """Builds the submodule by `command`, which starts SCons. Returns the exit status."""
    folder = os.path.join(root, SUBMODULE)
    if not os.path.isfile(os.path.join(folder, "SConstruct")):
        raise NotInitialised(f"{SUBMODULE} is empty: say `git submodule update --init --checkout {SUBMODULE}`, which needs "
                             "a network. Without it the library has the bundled binding.")
    return subprocess.run([*command, "-Q", *words], cwd=folder, env=environment).returncode
