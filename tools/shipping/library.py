"""Reads the headers of a shared library of any platform."""

import dataclasses
import struct


class Unreadable(Exception):
    """Not a library, or one that is broken. The text says how."""


@dataclasses.dataclass
class Library:
    """`platform` and `arch` are named as in the .gdextension file; names are as sources spell them, without the underscore
    that macOS puts before each."""

    platform: str
    arch: str
    exports: set = dataclasses.field(default_factory=set)
    imports: set = dataclasses.field(default_factory=set)
    # The libraries that it needs, and, on Linux, versions of their symbols such as GLIBC_2.17.
    needs: set = dataclasses.field(default_factory=set)
    versions: set = dataclasses.field(default_factory=set)
    # macOS: its own name, the oldest system, what is wrong with its signature ("" where nothing is), and how many of its
    # indirect symbols lead nowhere.
    name: str = ""
    oldest_system: tuple = ()
    signature: str = ""
    lost_symbols: int = 0


def text_at(data, offset):
    """The text at `offset` up to its zero."""
    return data[offset:data.index(b"\0", offset)].decode("utf-8", "replace")


def rows(data, form, offset, count):
    """`count` records of struct's `form`, one after another."""
    size = struct.calcsize(form)
    return [struct.unpack_from(form, data, offset + i * size) for i in range(count)]
