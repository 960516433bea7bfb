#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Fails when a C++ file or a shader is not as clang-format 14 would write it, or a C++ file lacks its licence line.

usage: check_format.py ROOT [--fix]
"""
import pathlib
import subprocess
import sys

CPP = {".h", ".cpp"}
SHADERS = {".comp", ".glsl"}
LICENCE = "// SPDX-License-Identifier: Apache-2.0"
BUILT = ("build", "out", ".")  # how folders begin that hold no sources


def files(root):
    """All C++ files and shaders, wherever they lie."""
    folders = (folder for folder in sorted(root.iterdir()) if folder.is_dir() and not folder.name.startswith(BUILT))
    return [path for folder in folders for path in sorted(folder.rglob("*")) if path.suffix in CPP | SHADERS]


def clang_format(root, paths, *arguments):
    """Runs it on C++ files and on shaders, which are C++ to it but for their includes: those depend on their order."""
    for suffixes, own in ((CPP, []), (SHADERS, ["--sort-includes=0"])):
        chosen = [str(path) for path in paths if path.suffix in suffixes]
        if chosen:
            yield subprocess.run(["clang-format-14", f"--style=file:{root / '.clang-format'}", *own, *arguments, *chosen],
                                 capture_output=True, text=True)


def misformatted(root, paths):
    for done in clang_format(root, paths, "--dry-run", "-Werror"):
        found = [line for line in done.stderr.splitlines() if "error:" in line]
        yield from found or ([done.stderr.strip() or "clang-format-14 failed"] if done.returncode else [])


def complaints(root):
    paths = files(root)
    for path in paths:
        if path.suffix in CPP and path.read_text().split("\n", 1)[0] != LICENCE:
            yield f"{path}: the first line must be '{LICENCE}'"
    yield from misformatted(root, paths)


def main():
    root = pathlib.Path(sys.argv[1])
    if "--fix" in sys.argv:
        for done in clang_format(root, files(root), "-i"):
            done.check_returncode()
    found = list(complaints(root))
    print("\n".join(found) or f"format: {len(files(root))} files are as they should be")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
