# SPDX-License-Identifier: Apache-2.0
"""tools/check_words.py lets pass comments that stand by themselves and cite what is there, and complains of each kind that does not.

usage: words.py ROOT
"""
import importlib.util
import pathlib
import sys
import tempfile

ROOT = pathlib.Path(sys.argv[1])
loader = importlib.util.spec_from_file_location("check_words", ROOT / "tools" / "check_words.py")
words = importlib.util.module_from_spec(loader)
loader.loader.exec_module(words)

DOCUMENTS = {
    "doc/references.md": "# References\n\n| section | what |\n|---|---|\n| 4.3.2 | laser, equation 4.3 |\n\n- **Winter and Chen 2002**: Title.\n",
    "doc/behaviour.md": "# Behaviour\n\n## Tools\n\nThe laser is that of the thesis, section 4.3.2.\n",
}
GOOD = [
    ("src/a/good.h", '// The laser (thesis, section\n// 4.3.2; doc/behaviour.md, "Tools").\nint a; // of voxels\n'),
    ("src/a/good.cpp", "// The same may begin a comment here.\nint b; // by equation 4.3 of the thesis\n"),
    ("src/a/paper.h", "// Swept (Winter and Chen\n// 2002, \"Image-swept volumes\") on 12 Mar 2026.\nint c;\n"),
    ("doc/other.md", "# The thesis\n\nChapter 4 of the thesis, and [more](behaviour.md): doc/references.md.\n"),
]
BAD = [
    ("src/a/bad.h", "// Of these so many.\nint a;\n", 1, 'begins with "Of"'),
    ("src/a/bad.h", "// A number.\nint a;\n\n// Those of the\n// other.\nint b;\n", 4, 'begins with "Those"'),
    ("apps/b/bad.h", "    // Likewise for b.\n    int b;\n", 1, 'begins with "Likewise"'),
    ("apps/b/bad.h", "int a;\nint b; // the same\n", 2, 'begins with "the same"'),
    ("src/a/bad.cpp", "// As the thesis has it.\n", 1, "without a section"),
    ("src/a/bad.comp", "// Thesis, section 4.3.9.\n", 1, "4.3.9 of the thesis is not in"),
    ("tests/bad.py", "# thesis, equation 4.4\n", 1, "4.4 of the thesis is not in"),
    ("doc/bad.md", "# Title\n\n- fine\n- the thesis says so\n", 4, "without a section"),
    ("src/a/bad.glsl", "// By repeated blurring (Winter 2003).\n", 1, "Winter 2003 is not in"),
    ("src/a/bad.cpp", "int a; // see doc/nothing.md\n", 1, "no nothing.md"),
    ("doc/bad.md", "See [there](nothing.md).\n", 1, "no nothing.md"),
    ("src/a/bad.h", '// A tool (doc/behaviour.md,\n// "Hammers").\n', 1, 'no section "Hammers"'),
]


def expect(condition, message):
    if not condition:
        sys.exit(f"FAILED: {message}")


def write(root, name, text):
    (root / name).parent.mkdir(parents=True, exist_ok=True)
    (root / name).write_text(text)


def main():
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        for name, text in [*DOCUMENTS.items(), *GOOD]:
            write(root, name, text)
        expect(not list(words.complaints(root)), f"what is right is complained of: {list(words.complaints(root))}")
        for name, text, line, what in BAD:
            write(root, name, text)
            found = list(words.complaints(root))
            expect(len(found) == 1 and found[0].startswith(f"{name}:{line}: ") and what in found[0],
                   f"{text!r} in {name}: expected {what!r} of line {line}, found {found}")
            (root / name).unlink()
    found = list(words.complaints(ROOT))
    expect(not found, "\n".join(found))
    print("passed")


main()
