#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Seed strokes of every shape and the numbers of segments that sessions name, replayed. usage: session_strokes.py VSTUDIO"""
import gzip
import json
import pathlib
import struct
import subprocess
import sys
import tempfile
import unittest

VSTUDIO = sys.argv.pop(1)
SIDE = 48
RADIUS = 20


def write_ball(path):
    middle = (SIDE - 1) / 2
    inside = bytearray()
    for z in range(SIDE):
        for y in range(SIDE):
            for x in range(SIDE):
                r2 = (x - middle) ** 2 + (y - middle) ** 2 + (z - middle) ** 2
                inside.append(100 if r2 < RADIUS ** 2 else 0)
    header = (f"NRRD0004\ntype: uint8\ndimension: 3\nspace: left-posterior-superior\nsizes: {SIDE} {SIDE} {SIDE}\n"
              "space directions: (1,0,0) (0,1,0) (0,0,1)\nspace origin: (0,0,0)\nencoding: raw\n\n")
    path.write_bytes(header.encode() + inside)


def labels_of(path):
    header, data = path.read_bytes().split(b"\n\n", 1)
    return gzip.decompress(data) if b"encoding: gzip" in header else data


class Sessions(unittest.TestCase):
    def setUp(self):
        self.holder = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.holder.name)
        write_ball(self.folder / "ball.nrrd")

    def tearDown(self):
        self.holder.cleanup()

    def run_session(self, *operations, status=0):
        """The label map that the operations end with, and the report."""
        session = self.folder / "session.json"
        session.write_text(json.dumps({
            "volumeStudioSession": 1, "volume": {"path": "ball.nrrd"},
            "operations": [{"op": "view", "range": [50, 255]}, *operations, {"op": "labels", "file": "labels.nrrd"}]}))
        result = subprocess.run([VSTUDIO, "run", session, "-o", self.folder / "out"], capture_output=True, text=True, timeout=300)
        self.assertEqual(result.returncode, status, result.stderr)
        report = json.loads((self.folder / "out" / "report.json").read_text())
        return labels_of(self.folder / "out" / "labels.nrrd") if status == 0 else result.stderr, report

    def seeded(self, shape, points, **more):
        return self.run_session({"op": "seed", "strokes": [{"shape": shape, "points": points}], **more})[0]

    def test_the_last_view_can_be_had_without_asking_for_it_in_the_session(self):
        session = self.folder / "session.json"
        session.write_text(json.dumps({"volumeStudioSession": 1, "volume": {"path": "ball.nrrd"},
                                       "operations": [{"op": "view", "range": [50, 255], "mode": "mip"}]}))

        def run(*more):
            return subprocess.run([VSTUDIO, "run", session, "-o", self.folder / "out", *more], capture_output=True, text=True,
                                  timeout=300)

        plain = run()
        self.assertEqual(plain.returncode, 0, plain.stderr)
        self.assertIn("the session asks for no picture", plain.stdout)
        self.assertEqual([path.name for path in (self.folder / "out").iterdir()], ["report.json"])
        seen = run("--picture", "last.png", "--size", "64x48")
        self.assertEqual(seen.returncode, 0, seen.stderr)
        self.assertNotIn("no picture", seen.stdout)
        picture = (self.folder / "out" / "last.png").read_bytes()
        self.assertEqual(struct.unpack(">II", picture[16:24]), (64, 48))
        for name in ("last.jpg", "../last.png"):
            refused = run("--picture", name)
            self.assertEqual(refused.returncode, 2, refused.stderr)
            self.assertIn(name, refused.stderr)

    # The ball's middle is at pixel 615, 435 of the usual viewport.
    LINE = [[520, 400], [700, 460]]
    SQUARE = [[560, 380], [680, 380], [680, 490], [560, 490]]

    def test_a_polyline_of_two_points_seeds_the_line_between_them(self):
        line = self.seeded("polyline", self.LINE, width=9)
        self.assertGreater(line.count(1), 8)
        self.assertEqual(line, self.seeded("free-form", self.LINE, width=9))
        self.assertGreater(self.seeded("polyline", self.LINE, width=40).count(1), 2 * line.count(1))

    def test_a_stencil_seeds_its_area_and_a_polyline_its_line(self):
        area = self.seeded("stencil", self.SQUARE)
        self.assertEqual(area, self.seeded("rectangle", [self.SQUARE[0], self.SQUARE[2]]))
        line = self.seeded("polyline", [*self.SQUARE, self.SQUARE[0]])
        self.assertGreater(area.count(1), 1.5 * line.count(1))

    def test_every_tool_takes_a_stencil(self):
        mask = {"shape": "stencil", "points": self.SQUARE}
        for operation in ({"op": "peel", "mask": mask, "layers": 4}, {"op": "drill", "mask": mask},
                          {"op": "scissors", "outline": mask}):
            self.run_session(operation)
            closed = json.loads(json.dumps(operation).replace("stencil", "polyline"))
            touched = [self.run_session(o)[1]["operations"][1]["voxels"] for o in (operation, closed)]
            self.assertEqual(*touched)
            self.assertGreater(touched[0], 100)

    SEED = {"op": "seed", "strokes": [{"shape": "polyline", "points": LINE}]}

    def named(self, name, **more):
        return {"op": "segment", "segment": name, **more}

    def test_the_first_segment_that_is_named_is_label_1(self):
        there = {"op": "seed", "strokes": [{"shape": "polyline", "points": [[560, 520], [660, 520]]}]}
        labels, _ = self.run_session(self.named("ball"), self.SEED, self.named("spot"), there)
        self.assertEqual(set(labels), {0, 1, 2})

    def test_the_first_one_stays_where_the_session_speaks_of_it(self):
        for last in (self.named("Segment 1"), {"op": "remove segment", "segment": "Segment 1"},
                     {"op": "edit segment", "edit": "unite", "other": "Segment 1"}):
            labels, _ = self.run_session(self.named("ball"), self.SEED, last)
            self.assertEqual(set(labels), {0, 2}, last)

    def test_a_numbered_name_is_another_segment(self):
        labels, _ = self.run_session(self.named("Segment 2"), self.SEED)
        self.assertEqual(set(labels), {0, 2})
        labels, _ = self.run_session(self.named("Segment 2", first=True), self.SEED)
        self.assertEqual(set(labels), {0, 1})

    def test_what_cannot_be_first_says_why(self):
        message, _ = self.run_session(self.SEED, self.named("ball", first=True), status=1)
        self.assertIn("'ball' cannot take the place of the first segment, which is in use already", message)

    def test_undo_says_once_what_it_took_back(self):
        _, report = self.run_session(self.SEED, {"op": "undo"}, {"op": "redo"})
        self.assertEqual([o["message"] for o in report["operations"][2:4]], ["seed", "seed"])


if __name__ == "__main__":
    unittest.main(verbosity=2)
