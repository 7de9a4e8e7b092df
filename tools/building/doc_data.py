"""The class help: all XML files of a folder as one array in a C++ source."""


def literal(byte):
    """A byte as a `char`, which has a sign on some processors and none on others."""
    return str(byte) if byte < 128 else f"'\\x{byte:02x}'"


def write_source(target, source, env):
    """An SCons action: the help files `source` one after another, as the engine's XML reader takes them."""
    text = b"\n".join(file.get_contents().strip() for file in sorted(source, key=str))
    lines = [", ".join(map(literal, text[i:i + 24])) for i in range(0, len(text), 24)]
    with open(str(target[0]), "w", encoding="ascii") as out:
        out.write("// Generated from extension/doc_classes.\n"
                  "extern const char undergrowth_doc_xml[];\n"
                  "extern const unsigned long undergrowth_doc_xml_size;\n"
                  "const char undergrowth_doc_xml[] = {\n" + ",\n".join(lines + ["0"]) + "\n};\n"
                  f"const unsigned long undergrowth_doc_xml_size = {len(text)};\n")
