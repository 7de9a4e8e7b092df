"""The smallest libraries of each system that hold what the package looks at, valid by default."""

import hashlib
import struct

ENTRY = "undergrowth_init"


def texts(names):
    """(bytes, {name: offset}) of a table of texts."""
    data, places = b"\0", {}
    for name in names:
        places[name] = len(data)
        data += name.encode() + b"\0"
    return data, places


def elf(machine=62, exports=(ENTRY,), imports=("__cxa_finalize",), needs=("libc.so.6",), versions=("GLIBC_2.17",), extra=b""):
    table, at = texts([*exports, *imports, *needs, *versions])
    symbols = bytes(24) + b"".join(struct.pack("<IBBHQQ", at[name], 0x10, 0, section, 0, 0)
                                   for names, section in ((exports, 1), (imports, 0)) for name in names)
    dynamic = b"".join(struct.pack("<qQ", 1, at[name]) for name in needs)
    needed = struct.pack("<HHIII", 1, len(versions), 0, 16, 0)
    for i, name in enumerate(versions):
        needed += struct.pack("<IHHII", 0, 0, 2, at[name], 16 if i + 1 < len(versions) else 0)
    parts, body, headers = [(11, symbols, 2, 0), (3, table, 0, 0), (6, dynamic, 2, 0), (0x6FFFFFFE, needed, 2, 1)], b"", bytes(64)
    for kind, part, link, info in parts:
        headers += struct.pack("<IIQQQQIIQQ", 0, kind, 0, 0, 64 + len(body), len(part), link, info, 0, 0)
        body += part
    body += extra
    head = b"\x7fELF\x02\x01\x01" + bytes(9) + struct.pack("<HHIQQQIHHHHHH", 3, machine, 1, 0, 0, 64 + len(body), 0, 64, 0,
                                                          0, 64, 1 + len(parts), 0)
    return head + body + headers


def pe(machine=0x8664, exports=(ENTRY,), needs=("KERNEL32.dll",), extra=b""):
    base, table_at = 0x1000, 0x400
    table, at = texts([*exports, *needs])
    names = b"".join(struct.pack("<I", base + table_at + at[name]) for name in exports)
    shown = struct.pack("<24xIIII", len(exports), 0, base + 40, 0) + names
    imported_at = len(shown)
    imported = b"".join(struct.pack("<12xI4x", base + table_at + at[name]) for name in needs) + bytes(20)
    section = (shown + imported).ljust(table_at, b"\0") + table + extra
    directories = struct.pack("<IIII", base if exports else 0, len(shown), base + imported_at, len(imported)) + bytes(112)
    header = struct.pack("<H", 0x20B) + bytes(110) + directories
    coff = struct.pack("<HHIIIHH", machine, 1, 0, 0, 0, len(header), 0x2000)
    start = b"MZ".ljust(60, b"\0") + struct.pack("<I", 64) + b"PE\0\0" + coff + header
    start += struct.pack("<8sIIII16x", b".rdata", len(section), base, len(section), 0x400)
    return start.ljust(0x400, b"\0") + section


def macho(machine=0x0100000C, exports=(ENTRY,), needs=("/usr/lib/libSystem.B.dylib",), name="@rpath/lib.dylib",
          oldest=(11, 0), indirect=(0, 0x80000000), is_signed=True, extra=b""):
    table, at = texts(["_" + name for name in exports])
    symbols = b"".join(struct.pack("<IBBHQ", at["_" + name], 0x0F, 1, 0, 0) for name in exports)

    def named(command, text):
        body = struct.pack("<IIII", 24, 0, 0, 0) + text.encode().ljust((len(text) // 8 + 1) * 8, b"\0")
        return struct.pack("<II", command, 8 + len(body)) + body

    commands = [named(0xD, name), *(named(0xC, text) for text in needs),
                struct.pack("<IIIIII", 0x32, 24, 1, oldest[0] << 16 | oldest[1] << 8, 0, 0)]
    size = sum(map(len, commands)) + 24 + 80 + 16 * is_signed
    data_at = 32 + size
    data = symbols + table + b"".join(struct.pack("<I", index) for index in indirect) + extra
    commands += [struct.pack("<IIIIII", 2, 24, data_at, len(exports), data_at + len(symbols), len(table)),
                 struct.pack("<II12I6I", 0xB, 80, *[0] * 12, data_at + len(symbols) + len(table), len(indirect), 0, 0, 0, 0)]
    end = data_at + len(data)
    if is_signed:
        commands.append(struct.pack("<IIII", 0x1D, 16, end, 20 + 44 + 32))
    body = struct.pack("<IiiIIIII", 0xFEEDFACF, machine, 3 if machine == 0x01000007 else 0, 6, len(commands), size, 0, 0) + b"".join(commands) + data
    if is_signed:
        directory = struct.pack(">IIIIIIIIIBBBBI", 0xFADE0C02, 44 + 32, 0x20400, 2, 44, 0, 0, 1, end, 32, 2, 0, 16, 0)
        body += struct.pack(">IIIII", 0xFADE0CC0, 20 + 44 + 32, 1, 0, 20) + directory + hashlib.sha256(body).digest()
    return body
