"""The C++ headers that the build needs: GLM for the core, doctest for its tests."""

import os
import shutil

from . import debian
from .place import make_folder

NEEDED = {"glm/vec3.hpp": "libglm-dev", "doctest/doctest.h": "doctest-dev"}
USUAL_FOLDERS = ("/usr/include", "/usr/local/include", "/opt/homebrew/include", "/opt/local/include")
FOLDER_VARIABLES = ("CPATH", "CPLUS_INCLUDE_PATH", "INCLUDE")
REMEDY = ("Install GLM and doctest (brew install glm doctest / pacman -S glm doctest / vcpkg install glm doctest),\n"
          "or name the folder that has them in CPLUS_INCLUDE_PATH (INCLUDE on Windows).")


def missing_packages(environment=os.environ, usual=USUAL_FOLDERS):
    """The Debian packages of those headers that no include folder of this machine has."""
    folders = list(usual)
    for variable in FOLDER_VARIABLES:
        folders += [folder for folder in environment.get(variable, "").split(os.pathsep) if folder]
    return [package for header, package in NEEDED.items()
            if not any(os.path.exists(os.path.join(folder, header)) for folder in folders)]


def include_folders(usual=USUAL_FOLDERS):
    """Folders to add to the compiler's search path; none where the machine has all headers itself, `usual` among others."""
    return [private_folder()] if missing_packages(usual=usual) else []


def private_folder():
    """The folder .toolchain/headers with all of them, which holds no headers of this machine's system."""
    packages = list(NEEDED.values())

    def fill(folder):
        debian.unpack(" and ".join(packages), packages, folder, REMEDY)
        shutil.rmtree(folder / "usr/share", ignore_errors=True)

    return make_folder("headers", " ".join(packages), fill) / "usr/include"
