"""Mesa's driver for AMD cards with a null device, and Vulkan's headers, in .toolchain/radv.

Only `./run bench parts=gpu` fetches it. Mesa 26, beside Debian testing's Godot, has no null device any more.
"""

import dataclasses
import json
import re
from pathlib import Path

from . import debian, unpacked
from .place import Missing, make_folder

SUITE = "trixie"  # Mesa 25.0.
PACKAGES = ["mesa-vulkan-drivers", "libvulkan-dev"]
REMEDY = "The estimate for graphics cards needs Debian's packages of that release."
# Of the C and C++ libraries, which every process has already, in one version.
PROCESS_LIBRARIES = re.compile(r"(ld-linux.*|lib(c|m|dl|rt|pthread|resolv|util|stdc\+\+|gcc_s|mvec))\.so(\.\d+)*$")


@dataclasses.dataclass(frozen=True)
class Radv:
    headers: Path
    libraries: Path
    description: dict  # Vulkan's description of the driver, with the library's place.


def fetch():
    folder = make_folder("radv", f"{SUITE}: {' '.join(PACKAGES)}", fill)
    libraries = folder / unpacked.libraries_of(folder, "libvulkan_radeon.so")
    found = sorted(folder.glob("usr/share/vulkan/icd.d/radeon_icd*.json"))
    if not found:
        raise Missing(f"Debian's package mesa-vulkan-drivers has changed: it has no driver for AMD cards.\n{REMEDY}")
    description = json.loads(found[0].read_text())
    description["ICD"]["library_path"] = str(libraries / "libvulkan_radeon.so")
    return Radv(folder / "usr/include", libraries, description)


def fill(folder):
    debian.unpack("Mesa's driver with a null device", PACKAGES, folder, REMEDY, suite=SUITE)
    for path in sorted(folder.rglob("*.so*")):
        is_other_driver = path.name.startswith("libvulkan_") and path.name != "libvulkan_radeon.so"
        if is_other_driver or PROCESS_LIBRARIES.match(path.name):
            path.unlink()
    unpacked.shed_weight(folder)
