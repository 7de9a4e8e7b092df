"""The table of the engine's C functions, read from its interface header."""

import re

DECLARATION = re.compile(r"\* @name (\w+).*?\*/\s*typedef [^;]*?\(\*(\w+)\)\s*\(", re.DOTALL)


def files(header):
    entries = DECLARATION.findall(header)
    if len(entries) < 100:
        raise SystemExit("the interface header has another form than expected")
    text = "".join(f"GODOT_INTERFACE_FUNCTION({kind}, {name})\n" for name, kind in entries)
    # Two types are spelled GDExtensions... in the header; godot-cpp spells them like the others.
    odd = [kind for _, kind in entries if kind.startswith("GDExtensionsInterface")]
    aliases = "".join(f"using {kind.replace('Extensions', 'Extension')} = {kind};\n" for kind in odd)
    return {
        "include/godot_cpp/generated/interface_functions.inc": text,
        "include/godot_cpp/generated/interface_aliases.inc": aliases,
    }
