"""Libraries of Linux: 64-bit ELF, little-endian (System V ABI, and the GNU extension of versions)."""

import struct

from .library import Library, Unreadable, rows, text_at

MACHINES = {62: "x86_64", 183: "arm64"}
SECTION = "<IIQQQQIIQQ"
SYMBOL = "<IBBHQQ"
DYNAMIC, DYNAMIC_SYMBOLS, NEEDED_VERSIONS = 6, 11, 0x6FFFFFFE
DT_NEEDED = 1
LOCAL = 0


def read(data):
    machine = struct.unpack_from("<H", data, 18)[0]
    if data[4:6] != b"\x02\x01" or machine not in MACHINES:
        raise Unreadable(f"an ELF file for another machine (number {machine})")
    result = Library("linux", MACHINES[machine])
    offset, = struct.unpack_from("<Q", data, 40)
    count, = struct.unpack_from("<H", data, 60)
    sections = rows(data, SECTION, offset, count)
    for _, kind, _, _, start, size, link, info, _, _ in sections:
        if kind == DYNAMIC_SYMBOLS:
            read_symbols(data, result, rows(data, SYMBOL, start, size // 24), sections[link][4])
        elif kind == DYNAMIC:
            texts = sections[link][4]
            result.needs = {text_at(data, texts + value) for tag, value in rows(data, "<qQ", start, size // 16)
                            if tag == DT_NEEDED}
        elif kind == NEEDED_VERSIONS:
            result.versions = set(read_versions(data, start, info, sections[link][4]))
    return result


def read_symbols(data, result, symbols, texts):
    for name, info, _, section, _, _ in symbols:
        if info >> 4 != LOCAL:
            (result.exports if section else result.imports).add(text_at(data, texts + name))


def read_versions(data, start, count, texts):
    for _ in range(count):
        _, entries, _, first, step = struct.unpack_from("<HHIII", data, start)
        place = start + first
        for _ in range(entries):
            _, _, _, name, next_entry = struct.unpack_from("<IHHII", data, place)
            yield text_at(data, texts + name)
            place += next_entry
        start += step
