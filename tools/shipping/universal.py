"""Universal libraries of macOS: a header and a whole Mach-O library for each processor (mach-o/fat.h, all in big endian)."""

import struct

from .library import Unreadable, rows

BEGINNING = b"\xca\xfe\xba\xbe"
# {processor: (number, number of its kind, bits of the alignment)}. The alignment is the size of the processor's pages.
PROCESSORS = {"x86_64": (0x01000007, 3, 12), "arm64": (0x0100000C, 0, 14)}
HEADER, ENTRY = ">4sI", ">iiIII"


def join(libraries):
    """The universal library of {processor: bytes of its library}: the bytes that `lipo -create` writes."""
    names = [name for name in PROCESSORS if name in libraries]
    header, body = struct.pack(HEADER, BEGINNING, len(names)), b""
    start = len(header) + struct.calcsize(ENTRY) * len(names)
    for name in names:
        machine, kind, bits = PROCESSORS[name]
        body += bytes(-(start + len(body)) % (1 << bits))
        header += struct.pack(ENTRY, machine, kind, start + len(body), len(libraries[name]), bits)
        body += libraries[name]
    return header + body


def each(data):
    """The libraries in the bytes `data`: the parts of a universal one, else the one that it is."""
    return list(split(data).values()) if data.startswith(BEGINNING) else [data]


def split(data):
    """{processor: bytes of its library}. Raises Unreadable where no system would load one of them."""
    beginning, count = struct.unpack_from(HEADER, data)
    if beginning != BEGINNING:
        raise Unreadable("no universal library")
    names = {machine: name for name, (machine, _, _) in PROCESSORS.items()}
    found = {}
    for machine, _, offset, size, bits in rows(data, ENTRY, struct.calcsize(HEADER), count):
        name = names.get(machine, f"number {machine:#x}")
        if offset + size > len(data):
            raise Unreadable(f"a broken library (its part for {name} ends behind it)")
        if name in PROCESSORS and offset % (1 << PROCESSORS[name][2]):
            raise Unreadable(f"a broken library (its part for {name} begins within a page)")
        found[name] = data[offset:offset + size]
    return found
