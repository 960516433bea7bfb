#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Material through the program: filled in, cut, kept in sessions, exported alone, refused in one line.

usage: fill.py VSTUDIO
"""
import json
import pathlib
import struct
import subprocess
import sys
import tempfile
import unittest

VSTUDIO = sys.argv.pop(1)
SIDE = 48


def call(*arguments):
    return subprocess.run([VSTUDIO, *map(str, arguments)], capture_output=True, text=True, timeout=300)


def block(path):
    """An empty block: 10 throughout."""
    path.write_bytes((f"NRRD0004\ntype: uint8\ndimension: 3\nspace: left-posterior-superior\nsizes: {SIDE} {SIDE} {SIDE}\n"
                      "space directions: (0.5,0,0) (0,0.5,0) (0,0,0.5)\nkinds: domain domain domain\nencoding: raw\n"
                      "space origin: (0,0,0)\n\n").encode() + bytes([10]) * SIDE**3)


def stl_volume(path):
    """The volume that a binary STL encloses, mm^3, and its number of triangles."""
    data = path.read_bytes()
    count = struct.unpack_from("<I", data, 80)[0]
    total = 0.0
    for n in range(count):
        a, b, c = (struct.unpack_from("<3f", data, 84 + 50 * n + 12 + 12 * k) for k in range(3))
        total += (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                  a[2] * (b[0] * c[1] - b[1] * c[0])) / 6
    return total, count


def labels(path):
    header, _, body = path.read_bytes().partition(b"\n\n")
    if b"encoding: gzip" in header or b"encoding: gz" in header:
        import gzip
        body = gzip.decompress(body)
    return body


BOX = {"op": "clip", "box": [[9.5, 9.5, 9.5], [29.5, 33.5, 25.5]], "inside": True}
PLATE = {"op": "material", "number": 1, "name": "plate", "value": 200, "colour": [0.2, 0.5, 0.9]}
VIEW = {"op": "view", "range": [100, 255], "mode": "surface"}


class Filling(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        block(self.folder / "block.nrrd")

    def session(self, *operations):
        path = self.folder / "session.json"
        path.write_text(json.dumps({"volumeStudioSession": 1, "volume": {"path": "block.nrrd"}, "operations": list(operations)}))
        return path

    def run_session(self, *operations):
        answer = call("run", self.session(*operations), "-o", self.folder / "out")
        self.assertEqual(answer.returncode, 0, answer.stderr)
        return json.loads((self.folder / "out" / "report.json").read_text())

    def refused(self, *operations):
        answer = call("run", self.session(*operations), "-o", self.folder / "out")
        self.assertNotEqual(answer.returncode, 0)
        lines = [line for line in answer.stderr.splitlines() if line]
        self.assertEqual(len(lines), 1, answer.stderr)
        return lines[0]

    def test_a_solid_from_nothing_is_written_alone(self):
        self.run_session(VIEW, PLATE, {"op": "fill", "material": 1, "stroke": BOX},
                         {"op": "material surface", "file": "plate.stl", "material": 1},
                         {"op": "filled", "file": "filled.nrrd"}, {"op": "picture", "file": "p.png", "samples": 1})
        mm3, triangles = stl_volume(self.folder / "out" / "plate.stl")
        # 20 x 24 x 16 voxels of half a millimetre, whose edges are rounded by the width of the radiation.
        self.assertAlmostEqual(mm3, 20 * 24 * 16 / 8, delta=0.06 * 20 * 24 * 16 / 8)
        self.assertGreater(triangles, 1000)
        written = labels(self.folder / "out" / "filled.nrrd")
        self.assertEqual(len(written), SIDE**3)
        self.assertEqual(set(written), {0, 1})
        self.assertEqual(written[(17 * SIDE + 20) * SIDE + 20], 1)
        self.assertAlmostEqual(sum(written), 20 * 24 * 16, delta=0.06 * 20 * 24 * 16)

    def test_cut_uncut_and_unfilled(self):
        hole = {"op": "clip", "box": [[14.5, 14.5, 14.5], [24.5, 24.5, 40]], "inside": True}
        fill = {"op": "fill", "material": 1, "stroke": BOX}
        self.run_session(VIEW, PLATE, fill, hole, {"op": "un-cut"}, {"op": "filled", "file": "cut.nrrd"},
                         {"op": "undo"}, {"op": "undo"}, {"op": "filled", "file": "whole.nrrd"},
                         {"op": "unfill", "stroke": hole}, {"op": "filled", "file": "unfilled.nrrd"},
                         {"op": "sculpture", "file": "sculpture.nrrd"})
        cut, whole, unfilled = (labels(self.folder / "out" / f"{name}.nrrd") for name in ("cut", "whole", "unfilled"))
        middle = (18 * SIDE + 18) * SIDE + 18
        self.assertEqual((cut[middle], whole[middle], unfilled[middle]), (0, 1, 0))
        self.assertEqual(cut, unfilled, "what cutting and unfilling leave of the fill")
        self.assertEqual(set(labels(self.folder / "out" / "sculpture.nrrd")), {0}, "unfilling cuts nothing")

    def test_a_saved_session_is_the_same(self):
        self.run_session(VIEW, PLATE, {"op": "fill", "material": 1, "stroke": BOX},
                         {"op": "filled", "file": "filled.nrrd"}, {"op": "picture", "file": "p.png", "samples": 1})
        once = (self.folder / "out" / "filled.nrrd").read_bytes()
        picture = (self.folder / "out" / "p.png").read_bytes()
        self.run_session(VIEW, PLATE, {"op": "fill", "material": 1, "stroke": BOX},
                         {"op": "filled", "file": "filled.nrrd"}, {"op": "picture", "file": "p.png", "samples": 1})
        self.assertEqual((self.folder / "out" / "filled.nrrd").read_bytes(), once)
        self.assertEqual((self.folder / "out" / "p.png").read_bytes(), picture)

    def test_what_cannot_be_filled_is_said_in_one_line(self):
        fill = {"op": "fill", "material": 1, "stroke": BOX}
        for operations, said in (([fill], "material: 1 must be one of the materials that there are (0)"),
                                 ([{"op": "material", "number": 32}], "31"),
                                 ([{"op": "material", "number": 2}], "the next one is number 1, not 2"),
                                 ([PLATE, {"op": "fill", "material": 1, "stroke": BOX | {"restore": True}}], "restores"),
                                 ([PLATE, {"op": "fill", "material": 1, "stroke": {"op": "un-cut"}}], "stroke"),
                                 ([{"op": "filled", "file": "f.nrrd"}], "nothing is filled"),
                                 ([PLATE, {"op": "material surface", "file": "f.stl"}], "nothing is filled"),
                                 ([PLATE, fill, {"op": "material surface", "file": "f.xyz"}], "f.xyz"),
                                 ([PLATE, {"op": "remove fill"}], "nothing is filled")):
            with self.subTest(said=said):
                self.assertIn(said, self.refused(*operations))
                left = [p.name for p in (self.folder / "out").glob("f.*")]
                self.assertEqual(left, [], "nothing half-done is left behind")


if __name__ == "__main__":
    unittest.main()
