# SPDX-License-Identifier: Apache-2.0
"""tools/check_format.py complains of a planted fault in every folder of sources, and of nothing in files that are as they should be.

usage: format.py ROOT
"""
import importlib.util
import pathlib
import shutil
import sys
import tempfile

ROOT = pathlib.Path(sys.argv[1])
spec = importlib.util.spec_from_file_location("check_format", ROOT / "tools" / "check_format.py")
check = importlib.util.module_from_spec(spec)
spec.loader.exec_module(check)

GOOD = f"{check.LICENCE}\nint twice(int x) {{ return 2 * x; }}\n"
BAD = f"{check.LICENCE}\nint twice( int x ) {{ return 2*x; }}\n"
PLACES = ("src/base/a.cpp", "apps/cli/a.h", "tests/unit/a.cpp", "bench/growing/a.cpp", "bench/a.h", "tools/a.cpp",
          "src/gl/shaders/a.comp", "src/gl/shaders/a.glsl", "bench/splatting/a.comp")
# Sorted, these would no longer compile.
INCLUDES = '#include "b.glsl"\n#include "a.glsl"\nvoid main() {}\n'


def expect(condition, message):
    if not condition:
        sys.exit(f"FAILED: {message}")


def main():
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        shutil.copy(ROOT / ".clang-format", root)
        for place in PLACES:
            (root / place).parent.mkdir(parents=True, exist_ok=True)
            (root / place).write_text(GOOD)
        expect(not list(check.complaints(root)), f"good files are complained of: {list(check.complaints(root))}")
        for place in PLACES:
            (root / place).write_text(BAD)
            found = list(check.complaints(root))
            expect(found and all(place in line for line in found), f"{place} is ill-formatted, and the check says {found}")
            (root / place).write_text(GOOD)
        (root / "bench/a.h").write_text(GOOD.split("\n", 1)[1])
        expect(["bench/a.h" in line for line in check.complaints(root)] == [True], "a missing licence is not complained of")
        (root / "bench/a.h").write_text(GOOD)
        (root / "src/gl/shaders/a.comp").write_text(INCLUDES)
        expect(not list(check.complaints(root)), "includes of a shader must stay in their order")
    print("passed")


main()
