"""Writes the names, types and default values of the API in C++."""

import re

NUMBERS = {
    "int": "int64_t", "int8": "int8_t", "int16": "int16_t", "int32": "int32_t", "int64": "int64_t",
    "uint8": "uint8_t", "uint16": "uint16_t", "uint32": "uint32_t", "uint64": "uint64_t",
    "char16": "char16_t", "char32": "char32_t", "float": "double", "double": "double",
}
MATH = (
    "Vector2 Vector2i Rect2 Rect2i Vector3 Vector3i Transform2D Vector4 Vector4i Plane Quaternion AABB Basis "
    "Transform3D Projection Color RID"
).split()
RENAMED_CLASSES = {"ClassDB": "ClassDBSingleton"}
# Reserved words of C++.
RENAMED_METHODS = {"typeof": "type_of", "new": "new_", "delete": "delete_", "union": "union_", "char": "chr"}


def snake(name):
    """Returns godot-cpp's file name of a class: MeshInstance3D -> mesh_instance3d."""
    name = re.sub(r"(.)([A-Z][a-z]+)", r"\1_\2", name)
    name = re.sub(r"([a-z0-9])([A-Z])", r"\1_\2", name)
    return name.replace("2_D", "2D").replace("3_D", "3D").lower()


def method(name):
    return RENAMED_METHODS.get(name, name)


class Names:
    """The C++ names of the API's types, and the set of generated classes."""

    def __init__(self, api, listed):
        self.classes = {entry["name"]: entry for entry in api["classes"]}
        self.builtins = {entry["name"]: entry for entry in api["builtin_classes"]}
        self.singletons = {entry["type"] for entry in api["singletons"]}
        self.known = self._closure(listed)

    def _closure(self, listed):
        """Returns the listed classes, those that the core needs, their bases, and the owners of enums that they use."""
        back = {new: old for old, new in RENAMED_CLASSES.items()}
        todo = [back.get(name, name) for name in listed] + ["ClassDB", "Object", "RefCounted"]
        known = set()
        while todo:
            name = todo.pop()
            if name in known:
                continue
            if name not in self.classes:
                raise SystemExit(f"the engine has no class {name}")
            known.add(name)
            entry = self.classes[name]
            todo += [entry["inherits"]] if "inherits" in entry else []
            todo += sorted(self.enum_owners(entry))
        return known

    def enum_owners(self, entry):
        owners = set()
        for type_name in signature_types(entry):
            owner = type_name.split("::")[-1].rpartition(".")[0] if re.match("enum::|bitfield::", type_name) else ""
            if owner in self.classes and owner != entry["name"]:
                owners.add(owner)
        return owners

    def cpp(self, type_name, meta=None):
        """Returns the C++ type of a value."""
        kind, _, rest = type_name.rpartition("::")
        if kind == "enum":
            return self._enum(rest)
        if kind == "bitfield":
            return f"BitField<{self._enum(rest)}>"
        if kind == "typedarray":
            element = rest.split(":")[-1]
            if element in self.classes:
                return f"TypedArray<{self.name(element)}>" if element in self.known else "Array"
            return f"TypedArray<{self.cpp(element)}>"
        if kind == "typeddictionary":
            return "Dictionary"
        if type_name in ("int", "float"):
            return "float" if meta == "float" else NUMBERS[meta or type_name]
        if type_name in self.classes:
            name = self.name(type_name)
            return f"Ref<{name}>" if self.classes[type_name]["is_refcounted"] else f"{name} *"
        return type_name

    def _enum(self, name):
        owner, _, enum = name.rpartition(".")
        return f"{self.name(owner)}::{enum}" if owner else enum

    @staticmethod
    def name(class_name):
        return RENAMED_CLASSES.get(class_name, class_name)

    def parameter(self, argument):
        """Returns one parameter of a declaration, without its default."""
        cpp = self.cpp(argument["type"], argument.get("meta"))
        name = "p_" + argument["name"]
        if cpp.endswith("*"):
            return cpp + name
        by_value = cpp == "bool" or cpp in NUMBERS.values() or cpp == "float" or re.match("enum::|bitfield::", argument["type"])
        return f"{cpp} {name}" if by_value else f"const {cpp} &{name}"

    def parameters(self, arguments, defaults):
        return ", ".join(
            self.parameter(a) + (f" = {self.default(a)}" if defaults and "default_value" in a else "") for a in arguments
        )

    def default(self, argument):
        value, cpp = argument["default_value"], self.cpp(argument["type"], argument.get("meta"))
        if value == "null":
            return "nullptr" if cpp.endswith("*") else f"{cpp}()"
        if value in ("[]", "{}") or value.endswith("([])"):
            return f"{cpp}()"
        if re.match("enum::|bitfield::", argument["type"]):
            return f"({cpp.replace('BitField<', '').replace('>', '')}){value}"
        return value.lstrip("&")

    def forward_declarations(self, type_names):
        """Returns the classes to declare before a header that uses these types, sorted."""
        found = {t.split("::")[-1].split(":")[-1] for t in type_names if not re.match("enum::|bitfield::", t)}
        return sorted(self.name(t) for t in found if t in self.classes)

    def usable(self, method_entry):
        """False for methods with raw pointers, which are for engine modules in C++."""
        return not any("*" in t for t in method_types(method_entry))


def method_types(entry):
    returned = entry.get("return_value", {}).get("type") or entry.get("return_type")
    return [a["type"] for a in entry.get("arguments", [])] + ([returned] if returned else [])


def signature_types(class_entry):
    return [t for m in class_entry.get("methods", []) for t in method_types(m)]


def write_enum(enum, prefix=""):
    """Returns an enum of the API as C++; bit fields have 64 bits."""
    base = " : uint64_t" if enum.get("is_bitfield") else ""
    values = "".join(f"{prefix}\t{v['name']} = {v['value']}{'ULL' if base else ''},\n" for v in enum["values"])
    return f"{prefix}enum {enum['name'].split('.')[-1]}{base} {{\n{values}{prefix}}};\n"
