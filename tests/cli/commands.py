#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Calls vstudio as a person would, rightly and wrongly. usage: commands.py VSTUDIO"""
import json
import pathlib
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib

VSTUDIO = sys.argv.pop(1)


def call(*arguments):
    return subprocess.run([VSTUDIO, *map(str, arguments)], capture_output=True, text=True, timeout=300)


def read_png(path):
    """Width, height and the raw RGBA rows of one of our own PNGs."""
    data = pathlib.Path(path).read_bytes()
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    place, packed, size = 8, b"", None
    while place < len(data):
        length, kind = struct.unpack(">I4s", data[place:place + 8])
        body = data[place + 8:place + 8 + length]
        if kind == b"IHDR":
            size = struct.unpack(">II", body[:8])
        if kind == b"IDAT":
            packed += body
        place += 12 + length
    return size[0], size[1], zlib.decompress(packed)


class Commands(unittest.TestCase):
    def setUp(self):
        self.holder = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.holder.name)
        self.raw = self.folder / "ramp.raw"
        # 24 x 20 x 16 voxels: a bright box in the middle of air.
        self.raw.write_bytes(bytes(200 if 6 <= x < 18 and 5 <= y < 15 and 4 <= z < 12 else x
                                   for z in range(16) for y in range(20) for x in range(24)))
        self.layout = ("--raw", "24x20x16:uint8:1,1,1.5")

    def tearDown(self):
        self.holder.cleanup()

    def expect_error(self, code, mentions, *arguments):
        result = call(*arguments)
        self.assertEqual(result.returncode, code, result)
        lines = result.stderr.splitlines()
        self.assertEqual(len(lines), 1, result.stderr)
        for text in mentions:
            self.assertIn(str(text), lines[0])

    def test_every_command_has_help(self):
        for command in ([], ["info"], ["render"], ["run"], ["grow"], ["sweep"], ["devices"], ["compare"]):
            result = call(*command, "--help")
            self.assertEqual(result.returncode, 0, command)
            self.assertIn("--help", result.stdout)

    def test_usage_errors_exit_with_2(self):
        self.expect_error(2, ["subcommand"])
        self.expect_error(2, ["VOLUME"], "info")
        picture = self.folder / "p.png"
        self.expect_error(2, ["mode 'xry'", "surface"], "render", self.raw, *self.layout, "-o", picture, "--mode", "xry")
        self.expect_error(2, ["range '5'"], "render", self.raw, *self.layout, "-o", picture, "--range", "5")
        self.expect_error(2, ["range '9:1'", "1:9"], "render", self.raw, *self.layout, "-o", picture, "--range", "9:1")
        self.expect_error(2, ["size '0x5'"], "render", self.raw, *self.layout, "-o", picture, "--size", "0x5")
        self.expect_error(2, ["ragnarok"], "render", self.raw, *self.layout, "-o", picture, "--ragnarok")
        self.expect_error(2, ["24y20"], "info", self.raw, "--raw", "24y20")
        self.expect_error(2, ["seed"], "grow", self.raw, *self.layout, "--seed", "1,2", "--range", "1:2", "-o",
                          self.folder / "l.nrrd")
        self.expect_error(2, ["blob"], "sweep", "--dims", "8,8,8", "--mask", "blob:3", "--path", "line:0,0,0:1,1,1",
                          "-o", self.folder / "s.nrrd")
        self.assertFalse(picture.exists())

    def test_other_errors_exit_with_1_and_name_the_file(self):
        self.expect_error(1, ["gone.nii"], "info", self.folder / "gone.nii")
        empty = self.folder / "empty.nrrd"
        empty.touch()
        self.expect_error(1, ["empty.nrrd"], "info", empty)
        text = self.folder / "text.nrrd"
        text.write_text("Dear doctor,\nthis is no scan.\n")
        self.expect_error(1, ["text.nrrd"], "info", text)
        self.expect_error(1, ["ramp.raw", "7680"], "info", self.raw, "--raw", "24x20x17:uint8")
        self.expect_error(1, ["nowhere"], "render", self.raw, *self.layout, "-o", self.folder / "nowhere" / "p.png")
        self.expect_error(1, ["nowhere"], "grow", self.raw, *self.layout, "--seed", "10,10,8", "--range", "100:255",
                          "-o", self.folder / "nowhere" / "l.nii.gz")
        self.expect_error(1, ["seed"], "grow", self.raw, *self.layout, "--seed", "99,1,1", "--range", "1:2", "-o",
                          self.folder / "l.nii.gz")
        self.expect_error(1, ["no.json"], "run", self.folder / "no.json", "-o", self.folder / "out")
        self.assertEqual([p.name for p in self.folder.iterdir() if p.name.startswith(".")], [], "no half-written files")

    def test_wrong_sessions_name_operation_and_member(self):
        session = self.folder / "s.json"

        def with_operations(*operations, **volume):
            session.write_text(json.dumps({"volumeStudioSession": 1, "operations": operations,
                                           "volume": {"path": "ramp.raw", "raw": "24x20x16:uint8", **volume}}))
            return "run", session, "-o", self.folder / "out"

        self.expect_error(1, ["operation 2", "'fly'", "peel"], *with_operations({"op": "undo"}, {"op": "fly"}))
        self.expect_error(1, ["operation 1", "layers"], *with_operations(
            {"op": "peel", "mask": {"shape": "ellipse", "points": [[1, 1], [9, 9]]}}))
        self.expect_error(1, ["mask.points[1]", "2 numbers"], *with_operations(
            {"op": "peel", "layers": 2, "mask": {"shape": "ellipse", "points": [[1, 1], [9]]}}))
        self.expect_error(1, ["'colour'"], *with_operations({"op": "view", "colour": "red"}))
        self.expect_error(1, ["inside the output folder"], *with_operations(
            {"op": "picture", "file": "../p.png"}))
        self.expect_error(1, ["operation 1 (undo)", "nothing to undo"], *with_operations({"op": "undo"}))
        self.expect_error(1, ["checksum"], *with_operations(checksum="0000000000000000"))
        session.write_text("{")
        self.expect_error(1, ["s.json", "JSON"], "run", session, "-o", self.folder / "out")
        session.write_text('{"volumeStudioSession": 99, "volume": {"path": "x"}, "operations": []}')
        self.expect_error(1, ["newer"], "run", session, "-o", self.folder / "out")

    def test_info_tells_geometry_and_values(self):
        result = call("info", self.raw, *self.layout, "--json")
        self.assertEqual(result.returncode, 0, result.stderr)
        info = json.loads(result.stdout)
        self.assertEqual(info["dims"], [24, 20, 16])
        self.assertEqual(info["spacing"], [1, 1, 1.5])
        self.assertEqual(info["range"], [0, 200])
        self.assertEqual(sum(info["histogram"]["counts"]), 24 * 20 * 16)

    def test_render_writes_the_picture_asked_for(self):
        for mode in ("surface", "mip", "xray"):
            picture = self.folder / f"{mode}.png"
            result = call("render", self.raw, *self.layout, "-o", picture, "--mode", mode, "--range", "100:255",
                          "--size", "120x90", "--azimuth", "30", "--elevation=-20", "--zoom", "1.2")
            self.assertEqual(result.returncode, 0, result.stderr)
            width, height, rows = read_png(picture)
            self.assertEqual((width, height), (120, 90))
            self.assertGreater(len(set(rows)), 20, "a picture, not one colour")
            again = self.folder / "again.png"
            call("render", self.raw, *self.layout, "-o", again, "--mode", mode, "--range", "100:255", "--size",
                 "120x90", "--azimuth", "30", "--elevation=-20", "--zoom", "1.2")
            self.assertEqual(call("compare", picture, again, "--max", "0").returncode, 0, "the same each time")
        self.expect_error(1, ["mip.png", "surface.png"], "compare", self.folder / "mip.png",
                          self.folder / "surface.png", "--mean", "0.1")

    def test_grow_fills_the_box_and_counts_generations(self):
        labels = self.folder / "labels.nrrd"
        result = call("grow", self.raw, *self.layout, "--seed", "6,5,4", "--range", "100:255", "-o", labels)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("960", result.stdout)  # 12 x 10 x 8 voxels
        info = json.loads(call("info", labels, "--json").stdout)
        self.assertEqual(info["spacing"], [1, 1, 1.5], "the input's geometry")
        self.assertEqual(info["range"], [0, 1])
        seeds = call("grow", self.raw, *self.layout, "--seed", "6,5,4", "--range", "100:255", "--steps", "0", "-o", labels)
        self.assertEqual(seeds.returncode, 0)
        self.assertEqual(sum(json.loads(call("info", labels, "--json").stdout)["histogram"]["counts"][128:]), 1)

    def test_sweep_writes_a_solid(self):
        solid = self.folder / "solid.nrrd"
        result = call("sweep", "--dims", "48,48,48", "--mask", "ellipse:12,8", "--path", "line:24,24,10:24,24,38", "-o", solid)
        self.assertEqual(result.returncode, 0, result.stderr)
        info = json.loads(call("info", solid, "--json").stdout)
        self.assertEqual(info["type"], "float32")
        self.assertAlmostEqual(info["range"][1], 1, delta=0.01)

    def test_devices_lists_one(self):
        result = call("devices")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("OpenGL", result.stdout)


if __name__ == "__main__":
    unittest.main(verbosity=2)
