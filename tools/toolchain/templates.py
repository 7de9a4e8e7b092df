"""What exported games are made of: Debian testing's templates of the same Godot, in .toolchain/templates.

A game is a copy of a template, and finds libraries in that folder and, what draws, in that of Debian's Godot.
"""

from . import debian, godot, unpacked
from .place import Missing, TOOLCHAIN, make_folder

PACKAGES = ["godot-template-debug", "godot-template-release", "patchelf"]
REMEDY = "Exports are tried with Debian's templates: elsewhere leave the suite `export` out."
KINDS = ("debug", "release")


def fetch():
    """{kind: path of the template}"""
    godot.fetch()
    folder = make_folder("templates", " ".join(PACKAGES), fill)
    return {kind: find(folder, kind) for kind in KINDS}


def find(folder, kind):
    found = [path for path in sorted(folder.rglob(f"*{kind}*")) if path.is_file() and path.stat().st_size > 10_000_000]
    if not found:
        raise Missing(f"Debian's package godot-template-{kind} has changed: it holds no template.\n{REMEDY}")
    return found[0]


def fill(folder):
    debian.unpack("Godot's export templates", PACKAGES, folder, REMEDY)
    for kind in KINDS:
        template = find(folder, kind)
        unpacked.give_own_loader(folder, TOOLCHAIN / "templates", str(template.relative_to(folder)), [TOOLCHAIN / "godot"])
    unpacked.shed_weight(folder)



def environment(surroundings):
    """`surroundings` in which a game that was exported from a template finds what draws."""
    drawing = TOOLCHAIN / "godot"
    drivers = {"LIBGL_DRIVERS_PATH": drawing / unpacked.libraries_of(drawing) / "dri",
               "VK_DRIVER_FILES": drawing / "usr/share/vulkan/icd.d/lvp_icd.json",
               "__EGL_VENDOR_LIBRARY_DIRS": drawing / "usr/share/glvnd/egl_vendor.d"}
    return {**surroundings, **{name: str(path) for name, path in drivers.items()}}
