"""Checks the language of comments and documentation; `./run lint` runs it.

Two rules: at most MAX_RATE words per 1,000 treat things as persons or are vague quantities, in each group of files; and
no sentence of the documentation has more than MAX_WORDS words. docs/glossary.md explains the rules.
"""

import re
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
MAX_RATE = 4.0
MAX_WORDS = 40
WORDS = (r"who|whoever|whom|whose|nobody|somebody|anybody", r"tells?|told|telling", r"asks?|asked|asking",
         r"stands?|stood|standing", r"wears?|worn|wore|dress(?:ed|es)?|dressing",
         r"so (?:many|much|far|high|long|wide|often)", r"yet to|no more|any more", r"others|otherwise",
         r"go(?:es|ing)? on", r"kept|keeps?", r"hears?|heard|knows?|known")
PATTERN = re.compile(r"\b(?:" + "|".join(WORDS) + r")\b", re.IGNORECASE)
# Group, folder, endings. FOREIGN texts are left out of the documentation.
GROUPS = (
    ("C++ comments", "extension", (".cpp", ".hpp", ".inc")),
    ("shader comments", "addons", (".gdshader", ".gdshaderinc")),
    ("editor comments", "addons", (".gd",)),
    ("demo comments", "demo_project", (".gd", ".gdshader", ".gdshaderinc")),
    ("test comments", "tests", (".cpp", ".hpp", ".gd", ".py")),
    ("tools", "tools", (".py", ".cpp", ".hpp")),
    ("class reference", "extension/doc_classes", (".xml",)),
    ("documentation", ".", (".md",)),
)
SKIPPED = {".toolchain", ".godot", ".git", "build", "bin"}
FOREIGN = {"THIRD_PARTY.md"}


def files(root, folder, endings):
    """The files of a group; links are not followed."""
    waiting = [root / folder]
    while waiting:
        for path in sorted(waiting.pop().iterdir()):
            if path.is_symlink() or path.name in SKIPPED | FOREIGN:
                continue
            if path.is_dir():
                waiting.append(path)
            elif path.suffix in endings:
                yield path


def prose(path, text):
    """The comments of a source, or the whole text of a document."""
    if path.suffix in (".gd", ".py"):
        return "\n".join(re.findall(r"#+(.*)", text) + re.findall(r'"""(.*?)"""', text, re.DOTALL))
    if path.suffix in (".md", ".xml"):
        return text
    return "\n".join(re.findall(r"//[/!<]*(.*)", text) + re.findall(r"/\*(.*?)\*/", text, re.DOTALL))


def rate(texts):
    """(words, words that PATTERN matches per 1,000 words)."""
    total = sum(len(re.findall(r"[A-Za-z']+", text)) for text in texts)
    found = sum(len(PATTERN.findall(text)) for text in texts)
    return total, 1000.0 * found / total if total else 0.0


def sentences(text):
    """The sentences of a Markdown document, without code, tables, headings and link targets."""
    text = re.sub(r"```.*?```|<!--.*?-->", "\n\n", text, flags=re.DOTALL)
    text = re.sub(r"\]\([^)]*\)", "]", text)
    for paragraph in re.split(r"\n\s*\n|\n(?=\s*(?:[-*]|\d+\.) )", text):
        lines = [line for line in paragraph.splitlines() if not re.match(r"\s*[|#]", line)]
        yield from re.split(r"(?<=[^\d][.!?:;])[\"*)]*\s+", " ".join(lines).strip())


def long_sentences(root=ROOT):
    """Each sentence of the documentation that is too long, as `file: count words: beginning`."""
    found = []
    for path in files(root, ".", (".md",)):
        for sentence in sentences(path.read_text(encoding="utf-8")):
            count = len(re.findall(r"[A-Za-z0-9']+", re.sub(r"`[^`]*`", "code", sentence)))
            if count > MAX_WORDS:
                found.append(f"{path.relative_to(root)}: {count} words: {sentence[:70]}...")
    return found


def check(root=ROOT):
    """Prints each group's rate and what is wrong; True if nothing is."""
    clean = True
    for name, folder, endings in GROUPS:
        texts = [(path, prose(path, path.read_text(encoding="utf-8"))) for path in files(root, folder, endings)]
        total, share = rate([text for _, text in texts])
        good = share < MAX_RATE
        clean &= good
        print(f"language: {name}: {total} words, {share:.1f} per 1,000, {'clean' if good else 'not clean'}")
        if not good:
            worst = sorted(texts, key=lambda item: -len(PATTERN.findall(item[1])))[:10]
            print("".join(f"  {path.relative_to(root)}: {len(PATTERN.findall(text))}\n" for path, text in worst), end="")
    too_long = long_sentences(root)
    print("".join(f"{line}\n" for line in too_long), end="")
    return clean and not too_long
