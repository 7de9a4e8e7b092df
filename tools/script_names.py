"""The engine's names that GDScript and scene files use, and those of them that a version of the engine lacks.

GDScript does not state the class of each value, so a name counts as present if any class of the engine has it. A name of
a class stated in the text, as in `ClassName.member`, must be a member of this class."""

import re

COMMENT_OR_STRING = re.compile(r'"""(?:.|\n)*?"""|&?\^?"(?:\\.|[^"\\\n])*"|&?\'(?:\\.|[^\'\\\n])*\'|#[^\n]*')
WORD = re.compile(r"(?<![\w.])([A-Za-z_]\w*)")
MEMBER = re.compile(r"\.\s*([A-Za-z_]\w*)")
QUALIFIED = re.compile(r"(?<![\w.])([A-Z]\w*)\.([A-Za-z_]\w*)")
# An own name: of a variable, constant, function, signal, enumeration, class, loop or parameter.
OWN = re.compile(r"\b(?:var|const|func|signal|enum|class|class_name|for)\s+([A-Za-z_]\w*)|[(,]\s*(\w+)\s*:")
NODE_TYPE = re.compile(r'\btype="(\w+)"')
PROPERTY = re.compile(r"^(\w+) = ", re.MULTILINE)


def members_of(entry):
    """The names of a class of a dump: methods, properties, signals, constants and enumerations with their values."""
    names = {one["name"] for kind in ("methods", "properties", "members", "signals", "constants") for one in entry.get(kind) or []}
    for one in entry.get("enums") or []:
        names |= {one["name"], *(value["name"] for value in one["values"])}
    return names


class Names:
    """All names of a dump, and those of each class with its base classes."""

    def __init__(self, dump):
        entries = dump["classes"] + dump.get("builtin_classes", [])
        self.bases = {entry["name"]: entry.get("inherits") for entry in entries}
        self.members = {entry["name"]: members_of(entry) for entry in entries}
        self.all = set(self.members) | {one["name"] for one in dump.get("utility_functions", [])}
        self.all |= members_of({"enums": dump.get("global_enums", []), "constants": dump.get("global_constants", [])})
        self.all |= {name for names in self.members.values() for name in names}

    def has(self, owner, member):
        while owner in self.members:
            if member in self.members[owner]:
                return True
            owner = self.bases[owner]
        return False


def own_names(text):
    """The names that a script declares."""
    return {name for pair in OWN.findall(COMMENT_OR_STRING.sub("", text)) for name in pair}


def used_in_script(text, declared=frozenset()):
    """(words, qualified words) of a script, without comments, strings, its own names, and members `declared` elsewhere."""
    code = COMMENT_OR_STRING.sub("", text)
    words = set(WORD.findall(code)) | set(MEMBER.findall(code)) - declared
    return words - own_names(text), set(QUALIFIED.findall(code))


def used_in_scene(text):
    """(words, no qualified words) of a scene or a resource file: types of nodes and names of properties."""
    return set(NODE_TYPE.findall(text)) | set(PROPERTY.findall(text)), set()


def lacking(used, own, other):
    """The used names of the API `own` that `other` lacks."""
    words, qualified = used
    lost = {word for word in words if word in own.all and word not in other.all}
    lost |= {f"{owner}.{member}" for owner, member in qualified if own.has(owner, member) and not other.has(owner, member)}
    # A class that is missing as a whole is named once.
    return sorted(name for name in lost if not ("." in name and name.partition(".")[0] in lost))
