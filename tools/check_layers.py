#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Fails when an #include goes against the arrows of doc/architecture.md, or a folder holds more files than a person oversees.

usage: check_layers.py ROOT
"""
import pathlib
import re
import sys

MOST_FILES = 45  # sources in one folder

# What each room may include besides itself, and with it all that those may include. A module is a folder of src; the folders in it
# are its rooms; so are those of the programs. What lies beside the rooms of a folder ("") may include them all.
MODULES = {
    "base": [],
    "volume": ["image"],
    "phantom": ["volume"],
    "reference": ["volume"],
    "image": ["base"],
    "gl": ["base"],
    "field": ["volume", "gl"],
    "sculpt": ["field"],
    "segment": ["field"],
    "marking": ["field"],
    "render": ["field"],
    "mesh": ["segment"],
    "studio": ["phantom", "reference", "sculpt", "segment", "marking", "render", "mesh"],
}
ROOMS = {
    "src/field": {"bricks": [], "sparse": [], "fill": ["sparse"], "marks": ["sparse"]},
    "src/volume": {"grid": [], "measures": ["grid"], "io": ["grid"], "dicom": ["io"], "store": ["io"], "tiff": ["io"],
                   "reading": ["dicom", "store", "tiff"]},
    "src/sculpt": {"mask": [], "path": [], "radiation": ["mask", "path"], "sculpture": ["radiation"],
                   "surface": ["sculpture"], "solids": ["sculpture"]},
    "src/segment": {"growth": [], "finer": ["growth"], "edits": ["finer"], "measures": ["edits"], "membership": ["finer"]},
    "src/render": {"colours": [], "camera": [], "space": ["colours"], "marks": ["camera", "colours"],
                   "slices": ["colours"], "rays": ["space", "marks"]},
    "src/studio": {"operations": [], "state": ["operations"], "strokes": ["state"],
                   "editing": ["strokes"], "marking": ["editing"], "filling": ["editing"],
                   "document": ["marking", "filling"],
                   "exports": ["document"], "json": ["document"], "cases": ["json"], "selfcheck": []},
    "apps/cli": {"reports": [], "arguments": ["reports"], "bench": [],
                 "sessions": ["arguments"],
                 "experiments": ["sessions"], "commands": ["experiments", "bench"]},
    "apps/desktop": {"engine": [], "model": ["engine"], "parts": ["model"], "tools": ["model"],
                     "view": ["tools", "parts"], "transfer": ["model", "parts"], "panels": ["tools", "transfer"],
                     "dialogs": ["model", "parts"], "start": ["model", "parts"],
                     "window": ["view", "panels", "dialogs", "start"], "testing": ["view"]},
    "apps/desktop/model": {"texts": [], "settings": ["texts"], "document": [], "hand": ["document"],
                           "edits": ["hand", "texts"], "segments": ["edits"], "slices": ["hand"],
                           "files": ["segments"], "studio": ["files", "slices", "settings"],
                           "exports": ["studio"], "keepers": ["studio"]},
    "apps/desktop/tools": {"kinds": [], "playing": []},
}
INCLUDE = re.compile(r'^\s*#\s*include\s+["<]([^">]+)[">]')


def reach(arrows):
    """For each room all that it may include."""
    found = {}

    def visit(room):
        if room not in found:
            found[room] = set(arrows[room]).union(*(visit(other) for other in arrows[room]))
        return found[room]

    for room in arrows:
        visit(room)
    return found


ALLOWED = reach(MODULES)
ALLOWED_ROOMS = {folder: reach(arrows) for folder, arrows in ROOMS.items()}


def includes(path):
    for number, line in enumerate(path.read_text().splitlines(), 1):
        match = INCLUDE.match(line)
        if match:
            yield number, match.group(1)


def against_modules(module, target):
    """What is wrong with an include in a module of src."""
    first = target.split("/")[0]
    if "/" in target and first in ALLOWED and first != module and first not in ALLOWED[module]:
        yield f"{module} must not include {first} ({target})"
    if re.match(r"(epoxy|EGL|GL|GLES\d)/", target) and module != "gl":
        yield f"only src/gl includes OpenGL headers ({target})"
    if re.match(r"Q[A-Z]", target):
        yield f"nothing in src includes Qt ({target})"


def against_rooms(root, folder, path, target):
    """What is wrong with an include between two rooms of one folder."""
    # Modules are spelled from src, what belongs to a program from its folder.
    base = root / ("src" if folder.startswith("src/") else "/".join(folder.split("/")[:2]))
    if not (base / target).is_file() or root / folder not in (base / target).parents:
        return
    parts = (path.relative_to(root / folder).parts, (base / target).relative_to(root / folder).parts)
    room, other = (p[0] if len(p) > 1 else "" for p in parts)
    allowed = ALLOWED_ROOMS[folder]
    if room and other not in {room, "shaders"} and other not in allowed[room]:
        yield f"{folder}/{room} must not include {other or 'what lies beside the rooms'} ({target})"


def sources(folder):
    return [p for p in sorted(folder.rglob("*")) if p.suffix in {".h", ".cpp", ".glsl", ".comp"}]


def complaints(root):
    for path in sources(root / "src") + sources(root / "apps"):
        parts = path.relative_to(root).parts
        folders = [folder for folder in ROOMS if root / folder in path.parents]
        for number, target in includes(path):
            wrong = list(against_modules(parts[1], target)) if parts[0] == "src" else []
            for folder in folders:
                wrong += against_rooms(root, folder, path, target)
            for what in wrong:
                yield f"{'/'.join(parts)}:{number}: {what}"
    yield from unknown_rooms(root)
    yield from crowded(root)


def unknown_rooms(root):
    for folder in sorted((root / "src").iterdir()):
        if folder.name not in MODULES:
            yield f"src/{folder.name}: not a module that this script knows"
    for name, rooms in ROOMS.items():
        for room in sorted((root / name).iterdir()):
            if room.is_dir() and sources(room) and room.name not in {*rooms, "shaders"}:
                yield f"{name}/{room.name}: not a room that this script knows"


def crowded(root):
    for folder in sorted({p.parent for p in sources(root / "src") + sources(root / "apps")}):
        count = sum(p.suffix in {".h", ".cpp"} for p in folder.iterdir())
        if count > MOST_FILES:
            yield f"{folder.relative_to(root)}: {count} sources in one folder; more than {MOST_FILES} are too many to oversee"


def main():
    found = list(complaints(pathlib.Path(sys.argv[1])))
    print("\n".join(found) or "layers: all includes follow the arrows")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
