#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Fails when a C++ file is not as clang-format 14 would write it, or lacks its licence line.

usage: check_format.py ROOT [--fix]
"""
import pathlib
import subprocess
import sys


def main():
    root = pathlib.Path(sys.argv[1])
    files = [p for folder in ("src", "apps", "tests") for p in sorted((root / folder).rglob("*"))
             if p.suffix in {".h", ".cpp"}]
    bad = [f"{p}: the first line must be '// SPDX-License-Identifier: Apache-2.0'" for p in files
           if not p.read_text().startswith("// SPDX-License-Identifier: Apache-2.0\n")]
    mode = ["-i"] if "--fix" in sys.argv else ["--dry-run", "-Werror"]
    result = subprocess.run(["clang-format-14", *mode, *map(str, files)], capture_output=True, text=True)
    bad += [line for line in result.stderr.splitlines() if "error:" in line]
    print("\n".join(bad) or f"format: {len(files)} files are as they should be")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
