"""Engine classes: a header and a source each, and the table that finds a class by its name."""

import re

from . import builtins, types

RENAMED = {("Node", "get_node"): "get_node_internal"}


def files(api, names, headers):
    result = {}
    for name in sorted(names.known):
        entry, snake = names.classes[name], types.snake(names.name(name))
        result[f"include/godot_cpp/classes/{snake}.hpp"] = header(entry, names, headers)
        result[f"src/classes/{snake}.cpp"] = source(entry, names)
    result["src/classes/engine_classes.cpp"] = table(names)
    return result


def cpp_name(entry, m):
    return RENAMED.get((entry["name"], m["name"]), types.method(m["name"]))


def methods(entry, names):
    return [m for m in entry.get("methods", []) if names.usable(m)]


def returned(m, names):
    value = m.get("return_value")
    return names.cpp(value["type"], value.get("meta")) if value else "void"


def header(entry, names, headers):
    name, own = names.name(entry["name"]), methods(entry, names)
    snake = types.snake(name)
    base = names.name(entry["inherits"]) if "inherits" in entry else "Wrapped"
    base_file = types.snake(base)
    includes = "".join(f"#include <godot_cpp/classes/{types.snake(names.name(o))}.hpp>\n" for o in sorted(names.enum_owners(entry)))
    forward = "".join(f"class {c};\n" for c in names.forward_declarations(types.signature_types(entry)) if c != name)
    body = "".join(types.write_enum(e, "\t") for e in entry.get("enums", []))
    body += "".join(f"\tstatic constexpr int {c['name']} = {c['value']};\n" for c in entry.get("constants", []))
    if entry["name"] in names.singletons:
        body += f"\tstatic {name} *get_singleton();\n"
    body += "\n" + "".join(declaration(entry, m, names) for m in own)
    if (headers / "classes" / "extras" / f"{snake}.inc").exists():
        body += f"#include <godot_cpp/classes/extras/{snake}.inc>\n"
    casts = "".join(f"VARIANT_{'BITFIELD' if e.get('is_bitfield') else 'ENUM'}_CAST({name}::{e['name']})\n" for e in entry.get("enums", []))
    return (
        f"#pragma once\n#include <array>\n#include <godot_cpp/classes/{base_file}.hpp>\n#include <godot_cpp/core/class_record.hpp>\n#include <godot_cpp/variant/typed_array.hpp>\n{includes}"
        f"\nnamespace godot {{\n{forward}\nclass {name} : public {base} {{\n\tGODOT_ENGINE_CLASS({name}, {base}, \"{entry['name']}\")\n\npublic:\n{body}"
        f"\nprotected:\n\ttemplate <typename T>\n\tstatic void _bind_virtuals(internal::VirtualTable &r_table) {{\n"
        f"\t\t{base}::_bind_virtuals<T>(r_table);\n{virtuals(name, own)}\t}}\n}};\n\n}} // namespace godot\n\n{casts}"
    )


def declaration(entry, m, names):
    name, arguments = cpp_name(entry, m), m.get("arguments", [])
    tail = " const" if m["is_const"] else ""
    if m["is_vararg"]:
        return builtins.vararg({**m, "name": name}, returned(m, names), names.parameters(arguments, False), tail)
    head = "virtual " if m["is_virtual"] else "static " if m["is_static"] else ""
    return f"\t{head}{returned(m, names)} {name}({names.parameters(arguments, True)}){tail};\n"


def virtuals(name, own):
    return "".join(
        f"\t\tGODOT_ENGINE_VIRTUAL({name}, {types.method(m['name'])}, {m['hash']});\n" for m in own if m["is_virtual"]
    )


def source(entry, names):
    name = names.name(entry["name"])
    used = {t.split("::")[-1].split(":")[-1] for t in types.signature_types(entry)} & names.known | {entry["name"]}
    text = "".join(f"#include <godot_cpp/classes/{types.snake(names.name(c))}.hpp>\n" for c in sorted(used))
    text += "#include <godot_cpp/core/engine_calls.hpp>\n#include <godot_cpp/variant/typed_array.hpp>\n\nnamespace godot {\n\n"
    if entry["name"] in names.singletons:
        text += f"{name} *{name}::get_singleton() {{\n\tstatic internal::Singleton singleton{{ \"{entry['name']}\" }};\n"
        text += f"\treturn static_cast<{name} *>(singleton.get());\n}}\n"
    return text + "".join(definition(entry, name, m, names) for m in methods(entry, names)) + "\n} // namespace godot\n"


def definition(entry, name, m, names):
    result, arguments = returned(m, names), m.get("arguments", [])
    tail = " const" if m["is_const"] else ""
    function, parameters = cpp_name(entry, m), names.parameters(arguments, False)
    given = "".join(f", p_{a['name']}" for a in arguments)
    if m["is_virtual"]:
        unnamed = ", ".join(re.sub(r" ?p_\w+$", "", names.parameter(a)) for a in arguments)
        body = "" if result == "void" else "\treturn {};\n"
        return f"{result} {name}::{function}({unnamed}){tail} {{\n{body}}}\n"
    if m["is_vararg"]:
        function, parameters, given = function + "_array", "const Variant *p_values, int64_t p_count", ", p_values, p_count"
    owner = "nullptr" if m["is_static"] else "_owner"
    call = "call_engine_array" if m["is_vararg"] else "call_engine"
    return (
        f"{result} {name}::{function}({parameters}){tail} {{\n"
        f"\tstatic internal::EngineMethod method{{ \"{entry['name']}\", \"{m['name']}\", {m['hash']} }};\n"
        f"\treturn internal::{call}<{result}>(method, {owner}{given});\n}}\n"
    )


def table(names):
    text = "".join(f"#include <godot_cpp/classes/{types.snake(names.name(c))}.hpp>\n" for c in sorted(names.known))
    text += "#include <godot_cpp/core/engine_class.hpp>\n\nnamespace godot::internal {\n\nconst EngineClass engine_classes[] = {\n"
    text += "".join(f"\t{{ \"{c}\", &create_wrapper<{names.name(c)}> }},\n" for c in sorted(names.known))
    return text + "};\nconst int engine_class_count = int(sizeof(engine_classes) / sizeof(EngineClass));\n\n} // namespace godot::internal\n"
