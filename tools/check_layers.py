#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Fails when an #include goes against the arrows of doc/architecture.md.

usage: check_layers.py ROOT
"""
import pathlib
import re
import sys

# What each folder of src/ may include from src/, besides itself.
ALLOWED = {
    "base": set(),
    "volume": {"base"},
    "image": {"base"},
    "gl": {"base"},
    "field": {"base", "volume", "image", "gl"},
}
for stage in ("sculpt", "segment", "render"):
    ALLOWED[stage] = ALLOWED["field"] | {"field"}
ALLOWED["mesh"] = ALLOWED["segment"] | {"segment"}
ALLOWED["studio"] = ALLOWED["render"] | {"sculpt", "segment", "render", "mesh"}

INCLUDE = re.compile(r'^\s*#\s*include\s+["<]([^">]+)[">]')


def complaints(root):
    for path in sorted((root / "src").rglob("*")):
        if path.suffix not in {".h", ".cpp", ".glsl", ".comp"}:
            continue
        module = path.relative_to(root / "src").parts[0]
        for number, line in enumerate(path.read_text().splitlines(), 1):
            match = INCLUDE.match(line)
            if not match:
                continue
            target = match.group(1)
            place = f"{path.relative_to(root)}:{number}"
            first = target.split("/")[0]
            if first in ALLOWED and "/" in target and first != module and first not in ALLOWED[module]:
                yield f"{place}: {module} must not include {first} ({target})"
            if re.match(r"(epoxy|EGL|GL|GLES\d)/", target) and module != "gl":
                yield f"{place}: only src/gl includes OpenGL headers ({target})"
            if re.match(r"Q[A-Z]", target):
                yield f"{place}: nothing in src includes Qt ({target})"


def main():
    found = list(complaints(pathlib.Path(sys.argv[1])))
    print("\n".join(found) or "layers: all includes follow the arrows")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
