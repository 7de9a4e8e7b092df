"""Libraries of macOS: 64-bit Mach-O of one processor (mach-o/loader.h, and cs_blobs.h for signatures)."""

import hashlib
import struct

from .library import Library, Unreadable, rows, text_at

MACHINES = {0x01000007: "x86_64", 0x0100000C: "arm64"}
SYMBOLS, DYNAMIC_SYMBOLS, OWN_NAME, SIGNATURE = 0x2, 0xB, 0xD, 0x1D
NEEDS = {0xC, 0x80000018, 0x8000001F}  # Plain, weak, and with its symbols passed on.
OLDEST, OLDEST_BEFORE = 0x32, 0x24  # LC_BUILD_VERSION, and what came before it.
EXTERNAL, KIND, DEFINED_NOWHERE = 0x01, 0x0E, 0x00
NO_SYMBOL = 0xC0000000  # Indirect symbols that are local or absolute name none.
SIGNATURE_PARTS, CODE_DIRECTORY, SHA256 = 0xFADE0CC0, 0xFADE0C02, 2


def read(data):
    machine, _, _, count = struct.unpack_from("<iiII", data, 4)
    if machine not in MACHINES:
        raise Unreadable(f"a library for another machine (number {machine:#x})")
    result = Library("macos", MACHINES[machine], signature="it has none")
    symbols, offset = (0, 0, 0), 32
    for _ in range(count):
        command, size = struct.unpack_from("<II", data, offset)
        if command == SYMBOLS:
            symbols = struct.unpack_from("<III", data, offset + 8)
            read_symbols(data, result, *symbols)
        elif command == DYNAMIC_SYMBOLS:
            first, number = struct.unpack_from("<II", data, offset + 56)
            result.lost_symbols = sum(not index & NO_SYMBOL and index >= symbols[1]
                                      for index, in rows(data, "<I", first, number))
        elif command == OWN_NAME:
            result.name = name_in(data, offset)
        elif command in NEEDS:
            result.needs.add(name_in(data, offset))
        elif command in (OLDEST, OLDEST_BEFORE):
            version, = struct.unpack_from("<I", data, offset + (12 if command == OLDEST else 8))
            result.oldest_system = (version >> 16, version >> 8 & 255)
        elif command == SIGNATURE:
            result.signature = signature_fault(data, *struct.unpack_from("<II", data, offset + 8))
        offset += size
    return result


def name_in(data, offset):
    return text_at(data, offset + struct.unpack_from("<I", data, offset + 8)[0])


def read_symbols(data, result, offset, count, texts):
    for name, kind, _, _, _ in rows(data, "<IBBHQ", offset, count):
        if kind & EXTERNAL:
            names = result.imports if kind & KIND == DEFINED_NOWHERE else result.exports
            names.add(text_at(data, texts + name).removeprefix("_"))


def signature_fault(data, start, size):
    """What is wrong with the signature at `start`: arm64 loads no library whose pages are not those that were signed."""
    magic, _, count = struct.unpack_from(">III", data, start)
    places = [start + offset for _, offset in rows(data, ">II", start + 12, count)] if magic == SIGNATURE_PARTS else []
    directory = next((place for place in places if data[place:place + 4] == CODE_DIRECTORY.to_bytes(4, "big")), None)
    if directory is None or start + size > len(data):
        return "it has no code directory"
    hashes, _, _, pages, end = struct.unpack_from(">IIIII", data, directory + 16)
    length, kind, _, page_bits = struct.unpack_from(">BBBB", data, directory + 36)
    if kind != SHA256 or end != start:
        return "it is of another kind than sha256 over all that comes before"
    for page in range(pages):
        place = directory + hashes + page * length
        signed = data[page << page_bits:min(end, (page + 1) << page_bits)]
        if hashlib.sha256(signed).digest()[:length] != data[place:place + length]:
            return f"page {page} is not what was signed"
    return ""
