#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""With VOLUME_STUDIO_HAZARDS=1 vstudio fails where a barrier is missing, and says between which passes: two shaders that are
edited here use memory that the barrier between them does not order.
usage: hazards.py VSTUDIO SOURCE_ROOT"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(sys.argv.pop(2))
VSTUDIO = sys.argv.pop(1)
SHADERS = pathlib.Path("render/shaders")
DECLARED = "layout(std430, binding = 0) {} buffer Planted {{ uint planted[]; }};\n"


class Hazards(unittest.TestCase):
    def setUp(self):
        self.holder = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.holder.name)
        self.raw = self.folder / "box.raw"
        self.raw.write_bytes(bytes(200 if 6 <= x < 18 and 5 <= y < 15 and 4 <= z < 12 else x
                                   for z in range(16) for y in range(20) for x in range(24)))
        (self.folder / SHADERS).mkdir(parents=True)

    def tearDown(self):
        self.holder.cleanup()

    # Edits a shader of the program: a declaration before main(), and a statement at its beginning.
    def edit(self, name, declaration, statement):
        text = (ROOT / "src" / SHADERS / name).read_text(encoding="utf-8")
        edited, count = re.subn(r"void main\(\) \{", lambda m: declaration + m[0] + " " + statement, text)
        self.assertEqual(count, 1, name)
        (self.folder / SHADERS / name).write_text(edited, encoding="utf-8")

    def plant(self):
        self.edit("find_beams.comp", DECLARED.format(""), "atomicOr(planted[0], 0u);")
        self.edit("mark_squares.comp", DECLARED.format("readonly"), "if (planted[0] == 0xfffffff1u) { return; }")

    def render(self, **variables):
        return subprocess.run(
            [VSTUDIO, "render", self.raw, "--raw", "24x20x16:uint8", "--range", "100:255", "--size", "64x48",
             "-o", self.folder / "box.png"],
            capture_output=True, text=True, timeout=300,
            env={**os.environ, "VOLUME_STUDIO_SHADER_DIR": str(self.folder), **variables})

    def test_the_program_has_none(self):
        result = self.render(VOLUME_STUDIO_HAZARDS="1")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertNotIn("hazard", result.stderr)

    def test_a_planted_one_fails_the_run_and_names_both_passes(self):
        self.plant()
        result = self.render(VOLUME_STUDIO_HAZARDS="1")
        self.assertNotEqual(result.returncode, 0)
        lines = [line for line in result.stderr.splitlines() if "hazard: " in line]
        self.assertEqual(len(lines), 1, result.stderr)
        for part in ("find_beams.comp (pass 'find beams') writes", "mark_squares.comp (pass 'mark squares') reads",
                     "GL_SHADER_STORAGE_BARRIER_BIT is missing"):
            self.assertIn(part, lines[0])
        self.assertIn("1 hazards were found", result.stderr.splitlines()[-1])

    def test_nobody_asks_without_the_variable(self):
        self.plant()
        result = self.render(VOLUME_STUDIO_HAZARDS="0")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertNotIn("hazard", result.stderr)


if __name__ == "__main__":
    unittest.main()
