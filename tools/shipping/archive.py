"""The zip to unpack in a project: what is in it, and what must hold of it."""

import re
import zipfile
from pathlib import Path

from . import checks

ROOT = Path(__file__).resolve().parents[2]
ADDON = "addons/undergrowth"
LIST = f"{ADDON}/undergrowth.gdextension"
NOTICES = ("LICENSE", "README.md", "THIRD_PARTY.md")
# What compilers leave beside a library.
LEFT_OUT = {".exp", ".lib", ".pdb", ".ilk"}
# The same files give the same archive.
FIXED_TIME = (2026, 1, 1, 0, 0, 0)
# Libraries for browsers are not in the zip: they depend on the version of Emscripten of the export templates.
LIBRARY = re.compile(r'^(linux|windows|macos)\.(debug|release)(?:\.(\w+))? = "(bin/\S+)"$', re.MULTILINE)
VERSION = re.compile(r'^version="(\S+)"$', re.MULTILINE)


def version(root=ROOT):
    """What the add-on says of itself in plugin.cfg; the changelog and the zip follow it."""
    return VERSION.search((root / ADDON / "plugin.cfg").read_text(encoding="utf-8")).group(1)


def place(root=ROOT, is_for_all=True):
    """Where the zip of the present version lies."""
    return root / "build" / f"undergrowth-{version(root)}{'' if is_for_all else '-here'}.zip"


def listed(text):
    """{name in the add-on: (platform, kind, arch)} of the libraries in the text of the .gdextension file. One without a
    processor is for all processors of its platform."""
    return {path: (platform, kind, arch or checks.UNIVERSAL) for platform, kind, arch, path in LIBRARY.findall(text)}


def is_shipped(path):
    """Not the copy `~lib…` of a library either that an open editor makes to reload it."""
    return path.is_file() and path.suffix not in LEFT_OUT and not path.name.startswith("~")


def files(root, libraries):
    """{name in the zip: path}: the add-on, with the libraries of the folder `libraries` as its bin/."""
    addon = root / ADDON
    found = {path.relative_to(root).as_posix(): path for path in sorted(addon.rglob("*"))
             if is_shipped(path) and addon / "bin" not in path.parents}
    found.update({f"{ADDON}/bin/{path.name}": path for path in sorted(libraries.glob("*")) if is_shipped(path)})
    return dict(sorted(found.items()))


def write(target, found):
    with zipfile.ZipFile(target, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, path in found.items():
            entry = zipfile.ZipInfo(name, FIXED_TIME)
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = (0o755 if path.suffix in (".so", ".dylib", ".x86_64") else 0o644) << 16
            archive.writestr(entry, path.read_bytes())


def build_paths(root=ROOT):
    """Paths that only the building machine has; `/root` alone is where a game's scene tree begins, too."""
    return [str(root)] + ([f"{Path.home()}/"] if len(Path.home().parts) > 2 else [])


def complaints(path, paths=(), is_for_all=True):
    """What is wrong with the zip at `path`, one clear sentence each."""
    try:
        with zipfile.ZipFile(path) as archive:
            held = {name: archive.read(name) for name in archive.namelist()}
    except (OSError, zipfile.BadZipFile, zipfile.zlib.error) as problem:
        return [f"{path.name} is no whole zip: {problem}"]
    if LIST not in held:
        return [f"{path.name} has no {LIST}"]
    libraries = listed(held[LIST].decode())
    inside = {name[len(ADDON) + 1:] for name in held if name.startswith(f"{ADDON}/bin/")}
    found = [f"{name} lies outside {ADDON}" for name in sorted(held) if not name.startswith(f"{ADDON}/")]
    found += [f"{ADDON}/{name} is missing" for name in NOTICES if f"{ADDON}/{name}" not in held]
    found += [f"{name} is in the zip, and undergrowth.gdextension does not list it" for name in sorted(inside - set(libraries))]
    missing = sorted(set(libraries) - inside)
    found += [f"{name} is missing" for name in missing] if is_for_all else []
    found += [] if inside else ["no library is in the zip"]
    for name in sorted(inside & set(libraries)):
        platform, _, arch = libraries[name]
        found += [f"{name}: {wrong}" for wrong in checks.complaints(
            held[f"{ADDON}/{name}"], platform, arch, Path(name).name, paths, is_for_all)]
    return found
