"""The zip of `./run package`: what is in it holds for all platforms. Not among the suites of the plain test."""

from shipping import archive
from toolchain.place import Missing

from . import newcomer, shipped
from .result import Result


def suites(godot):
    return [("package:zip", check_zip)] + newcomer.suites(godot)


def check_zip():
    """One test for each library that is in the zip, and one for the rest of it."""
    try:
        path = shipped.newest_zip()
    except Missing as missing:
        return Result("package:zip", 0, [str(missing)])
    is_for_all = path == archive.place()
    wrong = archive.complaints(path, archive.build_paths(), is_for_all)
    listed = archive.listed((archive.ROOT / archive.LIST).read_text(encoding="utf-8"))
    faulty = {name for name in listed for line in wrong if line.startswith(name)}
    held = len(listed) if is_for_all else 1
    return Result("package:zip", max(0, held - len(faulty)) + (not wrong), wrong, [f"{path.name} was looked at"])
