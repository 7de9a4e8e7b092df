#!/usr/bin/env python3
"""Builds the submodule godot-cpp as the library needs it. From then on builds use it in place of the bundled binding."""

import argparse
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "extension/binding"))

from building import binding, godot_cpp  # noqa: E402  (the path above comes first)
from generate import read_class_list  # noqa: E402
from toolchain import python_tools  # noqa: E402


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--godot", required=True, help="the engine whose API it is built for")
    parser.add_argument("--platform", required=True)
    parser.add_argument("--arch", required=True)
    parser.add_argument("--kinds", required=True, help="template_debug, template_release, or both, separated by commas")
    parser.add_argument("--without-threads", action="store_true")
    parser.add_argument("--jobs", type=int, default=1)
    options = parser.parse_args()
    command, environment = python_tools.scons()
    profile = godot_cpp.write_profile(ROOT, read_class_list(ROOT / "extension/binding/classes.txt"))
    try:
        binding.dump_api(options.godot, ROOT / "build/api")
        for kind in options.kinds.split(","):
            words = godot_cpp.words_for(ROOT / "build/api" / binding.API, profile, options.platform, options.arch, kind,
                                        not options.without_threads, options.jobs)
            status = godot_cpp.build(command, ROOT, words, environment)
            if status != 0:
                return status
    except (godot_cpp.NotInitialised, binding.BindingError) as problem:
        print(problem)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
