"""Finding sources, and compiling each into the folder of its variant below build/obj."""

import os

from . import compiler


def cpp_files(root, *folders):
    """The C++ files below `folders`, sorted, as paths from `root` with forward slashes."""
    found = []
    for folder in folders:
        for place, _, files in os.walk(os.path.join(root, folder)):
            found += [os.path.relpath(os.path.join(place, name), root) for name in files if name.endswith(".cpp")]
    return sorted(path.replace(os.sep, "/") for path in found)


def compile_all(env, variant, paths, shared=False):
    """The objects of `paths` in build/obj/<variant>; `shared` for those that end up in a shared library."""
    build = env.SharedObject if shared else env.Object
    return [build(f"#build/obj/{variant}/{path[:-len('.cpp')]}", f"#{path}") for path in paths]


def compile_core(env, variant, root, arch, shared=False):
    """The objects of the engine-free core; `env` is one of compiler.for_core."""
    objects = []
    for path in cpp_files(root, "extension/core"):
        name = os.path.basename(path)
        own = compiler.for_kernels(env, name, arch) if name.startswith("kernels") else env
        objects += compile_all(own, variant, [path], shared)
    return objects
