"""What exported games are made of: Debian testing's templates of the same Godot, in .toolchain/templates."""

from . import debian, godot, unpacked
from .place import Missing, TOOLCHAIN, make_folder

PACKAGES = ["godot-template-debug", "godot-template-release", "patchelf"]
REMEDY = "Exports are tried with Debian's templates: elsewhere leave the suite `export` out."
KINDS = ("debug", "release")


def fetch():
    """{kind: path of the template}, which start by themselves with the libraries of their folder."""
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
        unpacked.give_own_loader(folder, TOOLCHAIN / "templates", str(template.relative_to(folder)))
    unpacked.shed_weight(folder)



def environment(surroundings):
    """`surroundings` in which a game that was exported from a template finds the libraries of the template's folder, and
    those that draw in the folder of Debian's Godot."""
    godot.fetch()
    drawing = TOOLCHAIN / "godot"
    libraries = drawing / unpacked.libraries_of(drawing)
    drivers = {"LIBGL_DRIVERS_PATH": libraries / "dri", "VK_DRIVER_FILES": drawing / "usr/share/vulkan/icd.d/lvp_icd.json",
               "__EGL_VENDOR_LIBRARY_DIRS": drawing / "usr/share/glvnd/egl_vendor.d"}
    folders = [TOOLCHAIN / "templates" / unpacked.libraries_of(TOOLCHAIN / "templates"), libraries]
    search = ":".join(f"{folder}{below}" for folder in folders for below in unpacked.LIBRARY_FOLDERS)
    return {**surroundings, "LD_LIBRARY_PATH": search, **{name: str(path) for name, path in drivers.items()}}
