#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Marks through the program: kept in sessions, exported as colours of points and of voxels, refused in one line.

usage: marks.py VSTUDIO
"""
import json
import math
import pathlib
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib

VSTUDIO = sys.argv.pop(1)
SIDE = 64
RADIUS = 26
INK = (0, 0, 255)


def call(*arguments):
    return subprocess.run([VSTUDIO, *map(str, arguments)], capture_output=True, text=True, timeout=300)


def ball(path):
    """A ball of 200 about the middle, soft to half a voxel."""
    values = bytearray()
    for z in range(SIDE):
        for y in range(SIDE):
            for x in range(SIDE):
                beyond = math.dist((x, y, z), (SIDE / 2,) * 3) - RADIUS
                values.append(max(0, min(200, round(100 - 100 * beyond))))
    path.write_bytes((f"NRRD0004\ntype: uint8\ndimension: 3\nspace: left-posterior-superior\nsizes: {SIDE} {SIDE} {SIDE}\n"
                      "space directions: (1,0,0) (0,1,0) (0,0,1)\nkinds: domain domain domain\nencoding: raw\n"
                      "space origin: (10,20,30)\n\n").encode() + bytes(values))


VIEW = {"op": "view", "range": [100, 255], "mode": "surface", "camera": {"azimuth": 20, "elevation": 10}}
LINE = {"op": "mark", "kind": "line", "width": 8, "colour": [0, 0, 1],
        "sketch": {"shape": "polyline", "points": [[500, 400], [730, 470]]}}


class Marks(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        ball(self.folder / "ball.nrrd")

    def session(self, *operations, name="session.json"):
        path = self.folder / name
        path.write_text(json.dumps({"volumeStudioSession": 1, "volume": {"path": "ball.nrrd"}, "operations": list(operations)}))
        return path

    def run_session(self, *operations, more=()):
        answer = call("run", self.session(*operations), "-o", self.folder / "out", *more)
        self.assertEqual(answer.returncode, 0, answer.stderr)
        return json.loads((self.folder / "out" / "report.json").read_text())

    def refused(self, *operations):
        answer = call("run", self.session(*operations), "-o", self.folder / "out")
        self.assertNotEqual(answer.returncode, 0)
        self.assertEqual(len(answer.stderr.strip().splitlines()), 1, answer.stderr)
        return answer.stderr

    def test_a_volume_of_colours_has_them_where_the_pen_was(self):
        self.run_session(VIEW, LINE, {"op": "marks", "file": "marks.nrrd"})
        head, _, data = (self.folder / "out" / "marks.nrrd").read_bytes().partition(b"\n\n")
        fields = dict(line.split(": ", 1) for line in head.decode().splitlines() if ": " in line)
        self.assertEqual(fields["sizes"], f"4 {SIDE} {SIDE} {SIDE}")
        self.assertIn("RGBA-color", fields["kinds"])
        self.assertIn("(10,20,30)", fields["space origin"])
        texels = zlib.decompress(data, 31) if "gz" in fields["encoding"] else data
        marked = [i for i in range(SIDE ** 3) if texels[4 * i + 3] > 0]
        self.assertGreater(len(marked), 200)
        for i in marked:
            voxel = (i % SIDE, i // SIDE % SIDE, i // SIDE ** 2)
            self.assertLess(abs(math.dist(voxel, (SIDE / 2,) * 3) - RADIUS), 4, "about the surface")
            self.assertEqual(tuple(texels[4 * i:4 * i + 3]), INK)

    def test_surfaces_have_the_colours_of_marks_at_their_points(self):
        session = self.session(VIEW, LINE)
        for kind in ("ply", "obj", "glb"):
            answer = call("export", session, "--what", "volume", "-o", self.folder / f"ball.{kind}")
            self.assertEqual(answer.returncode, 0, answer.stderr)
        inked = self.in_ply()
        self.assertGreater(inked, 100)
        lines = [line.split() for line in (self.folder / "ball.obj").read_text().splitlines() if line.startswith("v ")]
        self.assertTrue(all(len(line) == 7 for line in lines))
        # Bytes round what is just about all ink.
        self.assertAlmostEqual(sum(float(line[6]) > 0.99 and float(line[4]) < 0.01 for line in lines), inked, delta=inked * 0.02)
        self.assertAlmostEqual(self.in_glb(), inked, delta=inked * 0.02)

    def in_ply(self):
        head, _, data = (self.folder / "ball.ply").read_bytes().partition(b"end_header\n")
        count = int(next(line.split()[-1] for line in head.decode().splitlines() if line.startswith("element vertex")))
        points = [struct.unpack_from("<3f3B", data, 15 * i) for i in range(count)]
        return sum(point[3:] == INK for point in points)

    def in_glb(self):
        data = (self.folder / "ball.glb").read_bytes()
        length = struct.unpack_from("<I", data, 12)[0]
        gltf = json.loads(data[20:20 + length])
        primitive = gltf["meshes"][0]["primitives"][0]
        self.assertEqual(gltf["materials"][primitive["material"]]["pbrMetallicRoughness"]["baseColorFactor"][:3], [1, 1, 1])
        accessor = gltf["accessors"][primitive["attributes"]["COLOR_0"]]
        begin = 28 + length + gltf["bufferViews"][accessor["bufferView"]]["byteOffset"]
        colours = [struct.unpack_from("<3f", data, begin + 12 * i) for i in range(accessor["count"])]
        return sum(c[2] > 0.99 and c[0] < 0.01 for c in colours)

    def test_what_is_not_marked_is_written_as_before(self):
        plain = self.session(VIEW)
        call("export", plain, "--what", "volume", "-o", self.folder / "ball.obj")
        first = next(line for line in (self.folder / "ball.obj").read_text().splitlines() if line.startswith("v "))
        self.assertEqual(len(first.split()), 4)

    def test_a_session_with_state_opens_as_it_was(self):
        picture = {"op": "picture", "file": "marked.png", "size": [300, 220]}
        saved = self.folder / "saved.json"
        eraser = {**LINE, "erase": True, "width": 3}
        undone = {**LINE, "kind": "area", "sketch": {"shape": "ellipse", "points": [[560, 380], [640, 460]]}}
        del undone["width"]
        self.run_session(VIEW, LINE, eraser, undone, {"op": "undo"}, picture, more=("--save", saved))
        before = (self.folder / "out" / "marked.png").read_bytes()
        self.assertEqual(call("check", saved).returncode, 0, "the state is what the log comes to")
        answer = call("run", saved, "--state", "-o", self.folder / "again", "--picture", "marked.png", "--size", "300x220")
        self.assertEqual(answer.returncode, 0, answer.stderr)
        compared = call("compare", self.folder / "out" / "marked.png", self.folder / "again" / "marked.png")
        self.assertIn("max 0 ", compared.stdout, "as it was before")
        self.assertTrue(before)

    def test_undo_to_the_start_is_the_unmarked_picture(self):
        picture = {"op": "picture", "size": [300, 220]}
        self.run_session(VIEW, {**picture, "file": "clean.png"}, LINE, {**picture, "file": "marked.png"}, {"op": "undo"},
                         {**picture, "file": "undone.png"})
        out = self.folder / "out"
        self.assertEqual((out / "clean.png").read_bytes(), (out / "undone.png").read_bytes())
        self.assertNotEqual((out / "clean.png").read_bytes(), (out / "marked.png").read_bytes())

    def test_what_is_wrong_is_said_in_one_line(self):
        text = {"op": "mark", "kind": "text", "text": "R", "sketch": {"shape": "free-form", "points": [[3, 3]]}}
        self.assertIn('to write "R" on', self.refused(VIEW, text))
        self.assertIn("#", self.refused(VIEW, {**text, "text": "R#"}))
        self.assertIn("pressures", self.refused(VIEW, {**LINE, "pressures": [1, 1, 1]}))
        self.assertIn("width", self.refused(VIEW, {**LINE, "width": -1}))
        self.assertIn("nothing is marked", self.refused(VIEW, {"op": "marks", "file": "marks.nrrd"}))
        self.assertIn(".nrrd", self.refused(VIEW, LINE, {"op": "marks", "file": "marks.nii"}))
        self.assertFalse((self.folder / "out" / "marks.nii").exists())
        self.assertIn("no mark", self.refused(VIEW, {"op": "remove marks"}))


if __name__ == "__main__":
    unittest.main()
