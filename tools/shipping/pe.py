"""Libraries of Windows: PE32+ (the Portable Executable format)."""

import struct

from .library import Library, Unreadable, rows, text_at

MACHINES = {0x8664: "x86_64", 0xAA64: "arm64"}
EXPORTS, IMPORTS, DELAYED = 0, 1, 13


def read(data):
    start, = struct.unpack_from("<I", data, 60)
    if data[start:start + 4] != b"PE\0\0":
        raise Unreadable("a program for DOS")
    machine, section_count, _, _, _, header_size, _ = struct.unpack_from("<HHIIIHH", data, start + 4)
    if machine not in MACHINES:
        raise Unreadable(f"a library for another machine (number {machine:#x})")
    header = start + 24
    sections = rows(data, "<8sIIII16x", header + header_size, section_count)

    def place(address):
        for _, _, first, size, offset in sections:
            if first <= address < first + size:
                return address - first + offset
        raise Unreadable(f"a broken library: no section holds the address {address:#x}")

    result = Library("windows", MACHINES[machine])
    addresses = [address for address, _ in rows(data, "<II", header + 112, 16)]
    if addresses[EXPORTS]:
        count, _, names = struct.unpack_from("<III", data, place(addresses[EXPORTS]) + 24)
        result.exports = {text_at(data, place(name)) for name, in rows(data, "<I", place(names), count)}
    for directory, form in ((IMPORTS, "<12xI4x"), (DELAYED, "<4xI24x")):
        if addresses[directory]:
            result.needs |= set(read_needs(data, place, place(addresses[directory]), form))
    return result


def read_needs(data, place, offset, form):
    """A row for each library, up to one that names none."""
    while True:
        name, = struct.unpack_from(form, data, offset)
        if not name:
            return
        yield text_at(data, place(name))
        offset += struct.calcsize(form)
