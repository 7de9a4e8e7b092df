"""The compiler for all platforms: `zig c++`, which brings clang and the systems' headers and libraries along."""

import os
import subprocess

from . import headers, python_tools
from .place import Missing, ROOT

ZIG = ["ziglang==0.17.1"]


def fetch():
    """The path of the program, in .toolchain/zig."""
    return python_tools.fetch("zig", ZIG) / "ziglang" / ("zig.exe" if os.name == "nt" else "zig")


def build(platform, arch, *words, program=None, jobs=None):
    """`scons WORDS` for another system; raises Missing on failure. Another scons may be running."""
    command, environment = python_tools.scons(PYTHONDONTWRITEBYTECODE="1", CPLUS_INCLUDE_PATH=str(headers.private_folder()))
    all_words = [*command, "-Q", f"-j{jobs or os.cpu_count() or 1}", *words, f"platform={platform}", f"arch={arch}",
                 f"zig={program or fetch()}"]
    if subprocess.run(all_words, cwd=ROOT, env=environment).returncode != 0:
        raise Missing(f"The build for {platform} on {arch} failed; the compiler's words stand above.")
