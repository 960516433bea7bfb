#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Fails when a header's comment leans on the line beside it, or a comment or document cites what cannot be found.

Comments of headers must not begin with a word like "Likewise". Whoever mentions the thesis names a section or an equation, and
doc/references.md has it; so it has every paper that comments in src cite by authors and year. Documents that are cited exist, and
so do the sections that are cited of doc/behaviour.md.

usage: check_words.py ROOT
"""
import pathlib
import re
import sys

SOURCES = {".h", ".cpp", ".glsl", ".comp", ".py"}
FOLDERS = ("src", "apps", "tests", "bench", "tools", "cmake", "doc")
CHECKS = ("check_words.py", "words.py")  # they have to speak of what is forbidden

LEANING = re.compile(r"(Of|Those|Likewise|The same|As|Instead|And|But|Also|Then)\b|likewise\b|the same\b")
NUMBERED = re.compile(r"(?:sections?|equations?|chapter|figure) ((?:(?: and | to )?(?:\d|B)(?:\.\d+)*)+)")
NUMBER = re.compile(r"(?:\d|B)(?:\.\d+)*")
PAPER = re.compile(r"(?<!\d )\b((?:Mc|[Vv]an )?[A-Z][a-zäöü]+)"
                   r"(?:(?:, and |, | and )[A-Z][a-zäöü]+)*(?: et al\.)? ((?:18|19|20)\d\d)\b(?=[,;:.)]|$| \()")
DOCUMENT = re.compile(r"\bdoc/[\w/-]+\.(?:md|json)\b")
LINK = re.compile(r"\]\(([^)#:]+\.md)\)")
SECTION = re.compile(r'behaviour(?:\.md)?\)?, "([^"]+)"')


def comments(path):
    """The comments of a source, each with its first line: those beside code, and those on lines of their own as one."""
    mark = r"#(?!!)" if path.suffix == ".py" else "//"
    text, first = [], 0
    for number, line in enumerate(path.read_text().splitlines() + [""], 1):
        own = re.match(rf"\s*{mark}+ ?(.*)", line)
        if own:
            first = first if text else number
            text.append(own.group(1))
            continue
        if text:
            yield first, " ".join(text)
            text = []
        beside = re.search(rf"\s{mark} (.*)", line)
        if beside:
            text, first = [beside.group(1)], number


def paragraphs(path):
    """The paragraphs, list entries and table rows of a document, each with its first line; headings are left out."""
    number = 1
    for block in re.split(r"\n(?=\s*\n|[-|#] ?)", path.read_text()):
        start = number + len(block) - len(block.lstrip("\n"))
        number += block.count("\n") + 1
        if not block.lstrip().startswith("#"):
            yield start, " ".join(block.split())


def headings(path):
    return set(re.findall(r"^#+ (.+)$", path.read_text(), re.MULTILINE)) if path.is_file() else set()


class References:
    """What doc/references.md has."""

    def __init__(self, root):
        path = root / "doc" / "references.md"
        text = path.read_text() if path.is_file() else ""
        cells = (line.split("|")[1] for line in text.splitlines() if line.startswith("| "))
        self.sections = {number for cell in cells for number in NUMBER.findall(cell)}
        self.sections |= set(re.findall(r"[3-7]\.\d+", " ".join(re.findall(r"equations? [\d. a-z]+", text))))
        self.papers = re.findall(r"^- \*\*(.+?)\*\*", text, re.MULTILINE)

    def has_section(self, number):
        return number in self.sections or any(known.startswith(number + ".") for known in self.sections)

    def has_paper(self, author, year):
        return any(re.search(rf"\b{author}\b", label) and label.endswith(year) for label in self.papers)


def about_thesis(text, references):
    if not re.search(r"\bthesis\b", re.sub(r'"[^"]*"', "", text), re.IGNORECASE):
        return
    numbers = [number for match in NUMBERED.finditer(text) for number in NUMBER.findall(match.group(1))]
    if not numbers and "references.md" not in text:
        yield "the thesis is cited without a section"
    for number in numbers:
        if not references.has_section(number):
            yield f"section or equation {number} of the thesis is not in doc/references.md"


def about_documents(root, path, text, sections):
    links = [path.parent / link for link in LINK.findall(text)] if path.suffix == ".md" else []
    for target in [root / name for name in DOCUMENT.findall(text)] + links:
        if not target.exists():
            yield f"there is no {target.name} where it is cited"
    for section in SECTION.findall(text):
        if section not in sections:
            yield f'doc/behaviour.md has no section "{section}"'


def about(root, path, text, references, sections):
    place = path.relative_to(root)
    if path.suffix == ".h" and LEANING.match(text):
        yield f'a comment begins with "{LEANING.match(text).group(0)}": say it without the line beside it'
    if path != root / "doc" / "references.md":
        yield from about_thesis(text, references)
    if place.parts[0] == "src":
        for author, year in PAPER.findall(text):
            if not references.has_paper(author, year):
                yield f"{author} {year} is not in doc/references.md"
    yield from about_documents(root, path, text, sections)


def complaints(root):
    references, sections = References(root), headings(root / "doc" / "behaviour.md")
    files = [p for folder in FOLDERS for p in sorted((root / folder).rglob("*")) if p.is_file() and p.name not in CHECKS]
    for path in files + sorted(root.glob("*.md")):
        if path.suffix in SOURCES or path.suffix == ".md":
            for line, text in paragraphs(path) if path.suffix == ".md" else comments(path):
                for what in about(root, path, text, references, sections):
                    yield f"{path.relative_to(root)}:{line}: {what}"


def main():
    found = list(complaints(pathlib.Path(sys.argv[1])))
    print("\n".join(found) or "words: comments stand by themselves, and what is cited is there")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
