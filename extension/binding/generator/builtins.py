"""Built-in types: opaque ones as whole classes, the math types' remaining methods, utility functions, enums."""

import re

from . import types

OPERATORS = {"==", "!=", "<", "<=", ">", ">=", "+"}
OPERATOR_NAMES = {"==": "EQUAL", "!=": "NOT_EQUAL", "<": "LESS", "<=": "LESS_EQUAL", ">": "GREATER", ">=": "GREATER_EQUAL", "+": "ADD"}
ELEMENTS = {
    "Byte": "uint8_t", "Int32": "int32_t", "Int64": "int64_t", "Float32": "float", "Float64": "double",
    "String": "String", "Vector2": "Vector2", "Vector3": "Vector3", "Vector4": "Vector4", "Color": "Color",
}


def files(api, names, headers):
    sizes = sizes_of(api)
    result = {}
    for entry in api["builtin_classes"]:
        name, snake = entry["name"], types.snake(entry["name"])
        if name in ("Nil", "bool", "int", "float"):
            continue
        if name in types.MATH:
            written = (headers / "variant" / f"{snake}.hpp").read_text()
            own = rf"^\t(?:static |constexpr |const )*\w+ &?{{}}\("
            methods = [m for m in entry.get("methods", []) if not re.search(own.format(m["name"]), written, re.M)]
            result[f"include/godot_cpp/generated/{snake}_methods.inc"] = declarations(methods, names)
        else:
            methods = entry.get("methods", [])
            result[f"include/godot_cpp/variant/{snake}.hpp"] = opaque_header(entry, names, headers, sizes[name])
        result[f"src/variant/{snake}.cpp"] = source(entry, methods, names)
    result["include/godot_cpp/generated/builtin_sizes.inc"] = "".join(
        f"GODOT_BUILTIN_SIZE({n}, {sizes[n]})\n" for n in list(names.builtins) + ["Variant"] if n not in ("Nil", "bool", "int", "float")
    )
    result.update(utility_functions(api, names))
    result.update(enums(api))
    return result


def sizes_of(api):
    """{type: its size as C++}, which differs where pointers have 32 bits."""
    tables = {table["build_configuration"]: {entry["name"]: entry["size"] for entry in table["sizes"]}
              for table in api["builtin_class_sizes"]}
    small, large = tables["float_32"], tables["float_64"]
    return {name: str(size) if small[name] == size else f"internal::size_of({small[name]}, {size})"
            for name, size in large.items()}


def declarations(methods, names):
    text = ""
    for m in methods:
        returned = m.get("return_type", "void")
        returned = "void" if returned == "void" else names.cpp(returned)
        head, tail = ("static ", "") if m["is_static"] else ("", " const" if m["is_const"] else "")
        parameters = names.parameters(m.get("arguments", []), True)
        if m["is_vararg"]:
            text += vararg(m, returned, parameters, tail)
        else:
            text += f"\t{head}{returned} {types.method(m['name'])}({parameters}){tail};\n"
    return text


def vararg(m, returned, parameters, tail):
    """Returns a template over the arguments, and the function behind it that takes them as an array."""
    name, fixed = types.method(m["name"]), [f"p_{a['name']}" for a in m.get("arguments", [])]
    between = ", " if fixed else ""
    given = ", ".join(f"Variant({a})" for a in fixed) + (", " if fixed else "") + "Variant(p_args)..."
    return (
        f"\t{returned} {name}_array(const Variant *p_values, int64_t p_count){tail};\n"
        f"\ttemplate <typename... Args>\n\t{returned} {name}({parameters}{between}const Args &...p_args){tail} {{\n"
        f"\t\tconst std::array<Variant, {len(fixed)} + sizeof...(Args)> values{{ {{ {given} }} }};\n"
        f"\t\treturn {name}_array(values.data(), int64_t(values.size()));\n\t}}\n"
    )


def opaque_header(entry, names, headers, size):
    name, snake = entry["name"], types.snake(entry["name"])
    used = {t for m in entry.get("methods", []) + entry["constructors"] for t in types.method_types(m)}
    used |= {o["right_type"] for o in operators(entry)}
    forward = "".join(f"class {t};\n" for t in sorted((used & set(names.builtins)) | {"Variant"}) if t[0].isupper() and t not in types.MATH)
    forward += "".join(f"class {t};\n" for t in names.forward_declarations(used))
    includes = "".join(f"#include <godot_cpp/variant/{types.snake(t)}.hpp>\n" for t in sorted(used) if t in types.MATH)
    element = ELEMENTS.get(name[len("Packed") : -len("Array")]) if name.startswith("Packed") else None
    if element and element[0].isupper():
        includes += f"#include <godot_cpp/variant/{element.lower()}.hpp>\n"
    defaults = {a["type"] for m in entry.get("methods", []) for a in m.get("arguments", []) if "default_value" in a}
    needed = (defaults - {name}) & {"String", "Variant", "Array", "Dictionary"}
    includes += "".join(f"#include <godot_cpp/variant/{types.snake(t)}.hpp>\n" for t in sorted(needed - {"Variant"}))
    if name == "String":
        includes += "#include <godot_cpp/variant/char_string.hpp>\n"
    if "Variant" in needed or any(m["is_vararg"] for m in entry.get("methods", [])):
        includes += "#include <godot_cpp/variant/variant_class.hpp>\n"
    body = f"\t{name}();\n\t{name}(const {name} &p_from);\n\t{name}({name} &&p_from);\n\texplicit {name}(internal::Uninitialized) {{}}\n"
    for constructor in entry["constructors"]:
        arguments = constructor.get("arguments", [])
        if arguments and not (len(arguments) == 1 and arguments[0]["type"] == name):
            body += f"\t{name}({names.parameters(arguments, False)});\n"
    body += f"\t~{name}();\n\t{name} &operator=(const {name} &p_from);\n\t{name} &operator=({name} &&p_from);\n\n"
    body += declarations(entry.get("methods", []), names) + "\n"
    for o in operators(entry):
        body += f"\t{names.cpp(o['return_type'])} operator{o['name']}(const {names.cpp(o['right_type'])} &p_other) const;\n"
    if element:
        body += f"#define GODOT_PACKED_ARRAY {name}\n#define GODOT_PACKED_ELEMENT {element}\n"
        body += f"#define GODOT_PACKED_INDEX {snake}_operator_index\n#define GODOT_PACKED_CONST_INDEX {snake}_operator_index_const\n#include <godot_cpp/variant/extras/packed_array.inc>\n"
    elif (headers / "variant" / "extras" / f"{snake}.inc").exists():
        body += f"#include <godot_cpp/variant/extras/{snake}.inc>\n"
    after = f"#include <godot_cpp/variant/extras/{snake}_after.inc>\n" if (headers / "variant" / "extras" / f"{snake}_after.inc").exists() else ""
    return (
        f"#pragma once\n#include <array>\n#include <initializer_list>\n#include <godot_cpp/core/defs.hpp>\n#include <godot_cpp/core/interface.hpp>\n{includes}"
        f"\nnamespace godot {{\n{forward}\nclass {name} {{\n\talignas(internal::alignment_of({size})) uint8_t _opaque[{size}];\n\npublic:\n{body}}};\n"
        f"{after}}} // namespace godot\n"
    )


def operators(entry):
    own = [o for o in entry["operators"] if o["name"] in OPERATORS and o.get("right_type") == entry["name"]]
    return own


def constant(name):
    return "GDEXTENSION_VARIANT_TYPE_" + types.snake(name).upper()


def source(entry, methods, names):
    name = entry["name"]
    text = "#include <godot_cpp/core/engine_calls.hpp>\n#include <godot_cpp/variant/builtin_types.hpp>\n\nnamespace godot {\n\n"
    if name not in types.MATH:
        text += f"GODOT_OPAQUE_TYPE({name}, {constant(name)})\n"
        for c in entry["constructors"]:
            arguments = c.get("arguments", [])
            if arguments and not (len(arguments) == 1 and arguments[0]["type"] == name):
                given = "".join(f", p_{a['name']}" for a in arguments)
                text += f"{name}::{name}({names.parameters(arguments, False)}) {{\n"
                text += f"\tinternal::construct({constant(name)}, {c['index']}, this{given});\n}}\n"
        for o in operators(entry):
            returned = names.cpp(o["return_type"])
            text += f"{returned} {name}::operator{o['name']}(const {names.cpp(o['right_type'])} &p_other) const {{\n"
            text += f"\tstatic internal::Operator op{{ GDEXTENSION_VARIANT_OP_{OPERATOR_NAMES[o['name']]}, {constant(name)}, {constant(o['right_type'])} }};\n"
            text += f"\treturn internal::call_operator<{returned}>(op, this, &p_other);\n}}\n"
    for m in methods:
        returned = names.cpp(m["return_type"]) if "return_type" in m else "void"
        arguments = m.get("arguments", [])
        tail = " const" if m["is_const"] else ""
        parameters = "const Variant *p_values, int64_t p_count" if m["is_vararg"] else names.parameters(arguments, False)
        function = types.method(m["name"]) + ("_array" if m["is_vararg"] else "")
        base = "nullptr" if m["is_static"] else "const_cast<void *>(static_cast<const void *>(this))"
        text += f"{returned} {name}::{function}({parameters}){tail} {{\n\tstatic internal::BuiltinMethod method{{ {constant(name)}, \"{m['name']}\", {m['hash']} }};\n"
        given = ", p_values, p_count" if m["is_vararg"] else "".join(f", p_{a['name']}" for a in arguments)
        text += f"\treturn internal::call_builtin{'_array' if m['is_vararg'] else ''}<{returned}>(method, {base}{given});\n}}\n"
    return text + "\n} // namespace godot\n"


def utility_functions(api, names):
    header = "#pragma once\n#include <godot_cpp/variant/builtin_types.hpp>\n#include <godot_cpp/variant/variant.hpp>\n\nnamespace godot {\nclass Object;\n\nclass UtilityFunctions {\npublic:\n"
    text = "#include <godot_cpp/classes/object.hpp>\n#include <godot_cpp/core/engine_calls.hpp>\n#include <godot_cpp/variant/utility_functions.hpp>\n\nnamespace godot {\n\n"
    for u in api["utility_functions"]:
        returned = names.cpp(u["return_type"]) if "return_type" in u else "void"
        name, arguments = types.method(u["name"]), u.get("arguments", [])
        method = {**u, "name": name}
        if u["is_vararg"]:
            method["arguments"] = []
            header += vararg(method, "static " + returned, "", "").replace("\ttemplate <typename... Args>\n\tstatic", "\ttemplate <typename... Args>\n\tstatic")
            parameters, given = "const Variant *p_values, int64_t p_count", ", p_values, p_count"
        else:
            parameters, given = names.parameters(arguments, False), "".join(f", p_{a['name']}" for a in arguments)
            header += f"\tstatic {returned} {name}({parameters});\n"
        suffix = "_array" if u["is_vararg"] else ""
        text += f"{returned} UtilityFunctions::{name}{suffix}({parameters}) {{\n\tstatic internal::UtilityFunction function{{ \"{u['name']}\", {u['hash']} }};\n"
        text += f"\treturn internal::call_utility{suffix}<{returned}>(function{given});\n}}\n"
    return {
        "include/godot_cpp/variant/utility_functions.hpp": header + "};\n\n} // namespace godot\n",
        "src/variant/utility_functions.cpp": text + "\n} // namespace godot\n",
    }


def enums(api):
    variant = ""
    plain = "#pragma once\n#include <cstdint>\n\nnamespace godot {\n\n"
    for enum in api["global_enums"]:
        if enum["name"].startswith("Variant."):
            enum = {**enum, "values": [{**v, "name": re.sub("^TYPE_", "", v["name"]).replace("MAX", "VARIANT_MAX") if v["name"].startswith("TYPE_") else v["name"]} for v in enum["values"]]}
            variant += types.write_enum(enum, "\t")
        else:
            plain += types.write_enum(enum) + "\n"
    casts = "".join(f"GODOT_GLOBAL_ENUM({e['name']})\n" for e in api["global_enums"] if "." not in e["name"])
    return {
        "include/godot_cpp/generated/variant_enums.inc": variant,
        "include/godot_cpp/generated/global_enums.inc": casts,
        "include/godot_cpp/classes/global_constants.hpp": plain + "} // namespace godot\n",
    }
