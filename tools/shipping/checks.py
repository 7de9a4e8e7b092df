"""Checks of each shipped library. Each function returns its complaints as sentences."""

import re
import struct

from . import elf, macho, pe, universal
from .library import Unreadable

READERS = {b"\x7fELF": elf.read, b"MZ": pe.read, b"\xcf\xfa\xed\xfe": macho.read}
ENTRY = "undergrowth_init"
UNIVERSAL = "universal"  # The processor of a library that holds one for each.
# Templates of the standard library that zig's linker shows on macOS: they take and give back memory as the system does.
SHOWN_ON_MACOS = {"_mh_execute_header", "_mh_dylib_header", "__dso_handle"}
ALLOCATION = re.compile(r"_Z(?:n[wa]|d[la]P)\w*")
# What each system has by itself.
NEEDS = {
    "linux": re.compile(r"lib(?:c|m|pthread|dl|rt)\.so\.\d|ld-linux-(?:x86-64|aarch64)\.so\.\d"),
    "windows": re.compile(r"KERNEL32\.dll|ntdll\.dll|api-ms-win-crt-[\w-]+\.dll", re.IGNORECASE),
    "macos": re.compile(r"/usr/lib/libSystem\.B\.dylib"),
}
NEWEST_GLIBC = (2, 28)
NEWEST_MACOS = {"x86_64": (10, 15), "arm64": (11, 0)}
# Calls what a library has to do when it is unloaded.
AT_UNLOAD = "__cxa_finalize"


def read(data):
    """The Library in the bytes `data`."""
    for beginning, reader in READERS.items():
        if data.startswith(beginning):
            try:
                return reader(data)
            except (struct.error, ValueError, IndexError) as error:
                raise Unreadable(f"a broken library ({error})") from None
    raise Unreadable("no library")


def complaints(data, platform, arch, file_name, paths=(), is_for_all=True):
    """What is wrong with the library `data`, called `file_name` and meant for `platform` and `arch`. `paths` are of the
    machine that built it. One that `is_for_all` needs what every such system has."""
    if arch == UNIVERSAL:
        return complaints_of_parts(data, platform, file_name, paths, is_for_all)
    try:
        library = read(data)
    except Unreadable as problem:
        return [f"it is {problem}"]
    if (library.platform, library.arch) != (platform, arch):
        return [f"it is for {library.platform} on {library.arch}"]
    found = wrong_exports(library)
    if is_for_all:
        found += wrong_needs(library) + wrong_system(library, file_name) + wrong_texts(data, paths)
    return found


def complaints_of_parts(data, platform, file_name, paths, is_for_all):
    try:
        parts = universal.split(data)
    except struct.error as error:
        return [f"it is a broken library ({error})"]
    except Unreadable as problem:
        return [f"it is {problem}"]
    if set(parts) != set(universal.PROCESSORS):
        return [f"it is for {' and '.join(sorted(parts)) or 'no processor'}"]
    return [f"for {arch} {wrong}" for arch, part in parts.items()
            for wrong in complaints(part, platform, arch, file_name, paths, is_for_all)]


def wrong_exports(library):
    shown = library.exports
    if library.platform == "macos":
        shown = {name for name in shown if name not in SHOWN_ON_MACOS and not ALLOCATION.fullmatch(name)}
    found = [] if ENTRY in shown else [f"it does not export {ENTRY}"]
    more = sorted(shown - {ENTRY})
    return found + ([f"it exports more than {ENTRY}: {some(more)}"] if more else [])


def wrong_needs(library):
    foreign = sorted(name for name in library.needs if not NEEDS[library.platform].fullmatch(name))
    return [f"it needs what a system may lack: {some(foreign)}"] if foreign else []


def wrong_system(library, file_name):
    return {"linux": wrong_linux, "windows": lambda *_: [], "macos": wrong_macos}[library.platform](library, file_name)


def wrong_linux(library, _):
    newer = sorted(name for name in library.versions if is_too_new(name))
    found = [f"it needs {some(newer)}, newer than glibc {dotted(NEWEST_GLIBC)} has"] if newer else []
    if AT_UNLOAD not in library.imports:
        found.append(f"it does not call {AT_UNLOAD}: the engine would crash when it ends")
    return found


def is_too_new(name):
    """True for a version of a symbol that glibc 2.28 or another library of the system does not have."""
    kind, _, number = name.rpartition("_")
    return kind != "GLIBC" or tuple(int(part) for part in re.findall(r"\d+", number)) > NEWEST_GLIBC


def wrong_macos(library, file_name):
    found = []
    if library.oldest_system > NEWEST_MACOS[library.arch]:
        found.append(f"it asks for macOS {dotted(library.oldest_system)}, newer than {dotted(NEWEST_MACOS[library.arch])}")
    if library.name != f"@rpath/{file_name}":
        found.append(f"it calls itself {library.name or 'nothing'} instead of @rpath/{file_name}")
    if library.lost_symbols:
        found.append(f"{library.lost_symbols} of its indirect symbols lead nowhere")
    if library.arch == "arm64" and library.signature:
        found.append(f"its signature does not hold: {library.signature}")
    return found


def wrong_texts(data, paths):
    return [f"it holds a path of the machine that built it: {path}" for path in paths if path.encode() in data]


def some(names, maximum=5):
    return ", ".join(names[:maximum]) + (f" and {len(names) - maximum} more" if len(names) > maximum else "")


def dotted(version):
    return ".".join(map(str, version))
