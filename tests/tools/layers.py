# SPDX-License-Identifier: Apache-2.0
"""tools/check_layers.py knows every room, lets pass what follows the arrows, and complains of an include of each forbidden kind.

usage: layers.py ROOT
"""
import importlib.util
import itertools
import pathlib
import sys
import tempfile

ROOT = pathlib.Path(sys.argv[1])
spec = importlib.util.spec_from_file_location("check_layers", ROOT / "tools" / "check_layers.py")
layers = importlib.util.module_from_spec(spec)
spec.loader.exec_module(layers)


def expect(condition, message):
    if not condition:
        sys.exit(f"FAILED: {message}")


def spelled(path):
    """As an include names a file: from src, or from its program's folder."""
    return "/".join(path.parts[1:] if path.parts[0] == "src" else path.parts[2:])


def planted(root, path, include):
    """What the check says about one include."""
    place = root / path
    before = place.read_text()
    place.write_text(f'#include "{include}"\n')
    found = list(layers.complaints(root))
    place.write_text(before)
    return found


def skeleton(root):
    """A header beside the rooms of each module, and one in each room; by module or program, and by folder with rooms."""
    modules = {module: pathlib.Path("src", module, f"{module}.h") for module in layers.MODULES}
    rooms = {folder: [pathlib.Path(folder, room, f"{room}_room.h") for room in arrows]
             for folder, arrows in layers.ROOMS.items()}
    for path in itertools.chain(modules.values(), *rooms.values()):
        (root / path).parent.mkdir(parents=True, exist_ok=True)
        (root / path).touch()
    return modules, rooms


def check_rooms(root, rooms):
    for folder, headers in rooms.items():
        for one, other in itertools.permutations(headers, 2):
            found = planted(root, one, spelled(other))
            if other.parent.name in layers.ALLOWED_ROOMS[folder][one.parent.name]:
                expect(not found, f"{one} may include {other}: {found}")
            else:
                expect(len(found) == 1 and "must not include" in found[0] and str(one) in found[0],
                       f"an include of {other} in {one} is not complained of: {found}")


def check_modules(root, modules):
    for one, other in itertools.permutations(modules, 2):
        found = planted(root, modules[one], spelled(modules[other]))
        expect(bool(found) == (other not in layers.ALLOWED[one]), f"{one} includes {other}: {found}")


def check_libraries(root, modules):
    for module, here in modules.items():
        expect(bool(planted(root, here, "epoxy/gl.h")) == (module != "gl"), f"OpenGL in {module}")
        expect(planted(root, here, "QObject"), f"Qt in {module}")


def check_unknown(root):
    for new in ("src/attic", "src/sculpt/attic", "apps/desktop/attic"):
        (root / new).mkdir()
        (root / new / "a.h").touch()
        expect(any(new in what for what in layers.complaints(root)), f"{new} is not complained of")
        (root / new / "a.h").unlink()
        (root / new).rmdir()


def check_crowd(root):
    many = [root / "src/base" / f"file{i}.cpp" for i in range(layers.MOST_FILES + 1)]
    for path in many:
        path.touch()
    expect(any("too many" in what for what in layers.complaints(root)), "a crowded folder is not complained of")
    for path in many:
        path.unlink()


def main():
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        modules, rooms = skeleton(root)
        expect(not list(layers.complaints(root)), "a tree without includes is complained of")
        check_rooms(root, rooms)
        check_modules(root, modules)
        check_libraries(root, modules)
        check_unknown(root)
        check_crowd(root)
    found = list(layers.complaints(ROOT))
    expect(not found, "\n".join(found))
    print("passed")


main()
