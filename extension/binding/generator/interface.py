"""The table of the engine's C functions that the binding uses, read from its interface header.

The library requests all of them when it is loaded. So the table omits unused ones: engines without them work, too.
"""

import re

DECLARATION = re.compile(r"\* @name (\w+).*?\*/\s*typedef [^;]*?\(\*(\w+)\)\s*\(", re.DOTALL)
USE = re.compile(r"\bgde\.(\w+)")
DEFINITION = re.compile(r"^#define (\w+) (\w+)$", re.MULTILINE)


def used_names(sources):
    """Returns the functions that the texts `sources` call, by their names or by macros for names."""
    called = {name for source in sources for name in USE.findall(source)}
    defined = {value for source in sources for name, value in DEFINITION.findall(source) if name in called}
    return {name for name in called | defined if name.islower() and name != "m_name"}


def files(header, used):
    entries = DECLARATION.findall(header)
    if len(entries) < 100:
        raise SystemExit("the interface header has another form than expected")
    missing = used - {name for name, _ in entries}
    if missing:
        raise SystemExit(f"this Godot's interface header has no {', '.join(sorted(missing))}; a newer one is needed")
    text = "".join(f"GODOT_INTERFACE_FUNCTION({kind}, {name})\n" for name, kind in entries if name in used)
    # Two types start with GDExtensions in the header. godot-cpp spells them like all other types.
    odd = [kind for _, kind in entries if kind.startswith("GDExtensionsInterface")]
    aliases = "".join(f"using {kind.replace('Extensions', 'Extension')} = {kind};\n" for kind in odd)
    return {
        "include/godot_cpp/generated/interface_functions.inc": text,
        "include/godot_cpp/generated/interface_aliases.inc": aliases,
    }
