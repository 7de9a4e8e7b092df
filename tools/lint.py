#!/usr/bin/env python3
"""Checks the format of C++ (clang-format) and GDScript (gdformat, gdlint), the includes of the core, and the language
of comments and documentation (prose.py).

    lint.py          prints what is wrong; the exit status is 0 only if nothing is
    lint.py --fix    formats in place first
"""

import argparse
import importlib.util
import re
import subprocess
import sys
from pathlib import Path

import prose

ROOT = Path(__file__).resolve().parents[1]
CPP_FOLDERS = ("extension", "tests", "tools")
GDSCRIPT_FOLDERS = ("addons", "demo_project", "tests", "tools")
SKIPPED = {".godot", "build", "bin"}
# C's standard headers and those of the processors.
C_HEADERS = {"math.h", "stddef.h", "stdint.h", "string.h", "cpuid.h", "emmintrin.h", "immintrin.h", "intrin.h", "arm_neon.h"}
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')


def files(folders, *suffixes):
    """The files below `folders`; links, such as the demo's addons/, are not followed."""
    found = []
    for folder in folders:
        waiting = [ROOT / folder]
        while waiting:
            place = waiting.pop()
            for path in sorted(place.iterdir()) if place.is_dir() else []:
                if path.is_dir() and not path.is_symlink() and path.name not in SKIPPED:
                    waiting.append(path)
                elif path.is_file() and path.suffix in suffixes:
                    found.append(path.relative_to(ROOT))
    return sorted(found)


def tool(name):
    """The words that start a formatter: the program in clang-format's package, a module's entry of gdtoolkit."""
    if name == "clang-format" and importlib.util.find_spec("clang_format"):
        return [sys.executable, "-c", "import sys, clang_format; sys.exit(clang_format.clang_format())"]
    if name != "clang-format" and importlib.util.find_spec("gdtoolkit"):
        package = {"gdformat": "formatter", "gdlint": "linter"}[name]
        return [sys.executable, "-c", f"import sys; sys.argv[0] = '{name}'; "
                f"from gdtoolkit.{package}.__main__ import main; sys.exit(main())"]
    return [name]


def check(name, words, paths):
    """Runs a checker over `paths`; True if it finds no fault."""
    if not paths:
        return True
    try:
        answer = subprocess.run([*tool(name), *words, *map(str, paths)], cwd=ROOT, text=True,
                                stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    except FileNotFoundError:
        print(f"{name} is missing: pip install {'clang-format' if name == 'clang-format' else 'gdtoolkit'}, or ./run lint")
        return False
    print(f"{name}: {len(paths)} files, {'clean' if answer.returncode == 0 else 'not clean'}")
    if answer.returncode != 0:
        # clang-format shows each position; the file is enough, since --fix corrects it whole.
        places = re.findall(r"^(.+?:\d+):\d+: error: code should be clang-formatted", answer.stdout, re.MULTILINE)
        firsts = {place.rsplit(":", 1)[0]: place for place in reversed(places)}
        print("\n".join(sorted(firsts.values())) or answer.stdout.rstrip())
    return answer.returncode == 0


def foreign_includes(paths):
    """Lines of the core that include anything but the standard library, GLM and the core itself."""
    core = ROOT / "extension/core"
    wrong = []
    for path in paths:
        for number, line in enumerate((ROOT / path).read_text(encoding="utf-8").splitlines(), 1):
            found = INCLUDE.match(line)
            if found and not is_allowed(found.group(1), found.group(2), core):
                wrong.append(f"{path}:{number}: {line.strip()}")
    return wrong


def is_allowed(quote, name, core):
    """Quoted: a file of the core. In angles: GLM or a standard header, which has no folder and no suffix."""
    if quote == '"':
        return (core / name).is_file()
    return name.startswith("glm/") or name in C_HEADERS or re.fullmatch(r"[a-z_0-9]+", name) is not None


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--fix", action="store_true")
    fix = parser.parse_args().fix
    cpp, scripts = files(CPP_FOLDERS, ".cpp", ".hpp"), files(GDSCRIPT_FOLDERS, ".gd")
    if fix:
        check("clang-format", ["-i"], cpp)
        check("gdformat", [], scripts)
    clean = [check("clang-format", ["--dry-run", "--Werror"], cpp), check("gdformat", ["--check"], scripts),
             check("gdlint", [], scripts)]
    core = files(["extension/core"], ".cpp", ".hpp", ".inc")
    wrong = foreign_includes(core)
    print(f"includes of the core: {len(core)} files, {'not clean' if wrong else 'clean'}")
    print("".join(line + "\n" for line in wrong), end="")
    return 0 if prose.check() and all(clean) and not wrong else 1


if __name__ == "__main__":
    sys.exit(main())
