#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measures labels with vstudio stats and vstudio grow --compare, rightly and wrongly.

usage: measure.py VSTUDIO [DATA_FOLDER]     (real volumes are left out where DATA_FOLDER is not there)
"""
import csv
import json
import math
import os
import pathlib
import statistics
import struct
import subprocess
import sys
import tempfile
import unittest

DATA = pathlib.Path(sys.argv.pop(2)) if len(sys.argv) > 2 else pathlib.Path("none")
VSTUDIO = sys.argv.pop(1)
DIMS = (24, 20, 16)
BOX = ((6, 18), (5, 15), (4, 12))  # 12 x 10 x 8 voxels of value 200


def call(*arguments):
    return subprocess.run([VSTUDIO, *map(os.fspath, map(as_argument, arguments))], capture_output=True, text=True,
                          errors="replace", timeout=300)


def as_argument(value):
    return value if isinstance(value, (bytes, os.PathLike)) else str(value)


def in_box(voxel, shift=0):
    return all(lo + (shift if axis == 0 else 0) <= v < hi + (shift if axis == 0 else 0)
               for axis, (v, (lo, hi)) in enumerate(zip(voxel, BOX)))


def write_nrrd(path, value, kind="uint8", code="B", dims=DIMS, spacing=(1, 1, 1.5), origin=(0, 0, 0)):
    """A grid from a function of (x, y, z), x fastest."""
    values = [value((x, y, z)) for z in range(dims[2]) for y in range(dims[1]) for x in range(dims[0])]
    header = (f"NRRD0004\ntype: {kind}\ndimension: 3\nspace: left-posterior-superior\nsizes: {dims[0]} {dims[1]} {dims[2]}\n"
              f"space directions: ({spacing[0]},0,0) (0,{spacing[1]},0) (0,0,{spacing[2]})\nkinds: domain domain domain\n"
              f"endian: little\nencoding: raw\nspace origin: ({origin[0]},{origin[1]},{origin[2]})\n\n")
    path.write_bytes(header.encode() + struct.pack(f"<{len(values)}{code}", *values))
    return path


class Measure(unittest.TestCase):
    def setUp(self):
        self.holder = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.holder.name)
        self.volume = write_nrrd(self.folder / "volume.nrrd", lambda v: 200 if in_box(v) else v[0] - 40, "int16", "h")

    def tearDown(self):
        self.holder.cleanup()

    def labels(self, name, value, *arguments, **grid):
        return write_nrrd(self.folder / name, value, *arguments, **grid)

    def stats(self, labels):
        table = self.folder / "t.csv"
        result = call("stats", labels, "--volume", self.volume, "--csv", table)
        self.assertEqual(result.returncode, 0, result)
        with open(table, newline="", encoding="utf-8") as file:
            return result.stdout.splitlines(), list(csv.DictReader(file))

    def refused(self, code, mentions, *arguments):
        result = call(*arguments)
        self.assertEqual(result.returncode, code, result)
        self.assertEqual(len(result.stderr.splitlines()), 1, result.stderr)
        self.assertEqual(result.stdout, "")
        for text in mentions:
            self.assertIn(str(text), result.stderr)

    def test_the_table_says_what_labels_cover(self):
        # A box of one value, and a wall of the ramp beside it; labels of two bytes need not be small.
        labels = self.labels("l.nrrd", lambda v: 3 if in_box(v) else 1200 if v[0] < 4 else 0, "uint16", "H")
        lines, rows = self.stats(labels)
        self.assertEqual([line.split()[0] for line in lines], ["label", "3", "1200"])
        self.assertEqual(len({len(line) for line in lines}), 1, "aligned")
        self.assertEqual([row["label"] for row in rows], ["3", "1200"])
        box, wall = rows
        self.assertEqual((box["voxels"], box["volume_ml"]), ("960", "1.44"))
        self.assertEqual([box[key] for key in ("mean", "standard_deviation", "minimum", "median", "maximum")],
                         ["200", "0", "200", "200", "200"])
        self.assertEqual([box[f"box_from_{axis}"] for axis in "ijk"], ["6", "5", "4"])
        self.assertEqual([box[f"box_to_{axis}"] for axis in "ijk"], ["17", "14", "11"])
        self.assertEqual([box[f"box_size_{axis}_mm"] for axis in "ijk"], ["12", "10", "12"])
        self.assertEqual([box[f"centroid_{axis}_mm"] for axis in ("left", "posterior", "superior")], ["11.5", "9.5", "11.25"])
        # Its faces hold 2 (12 x 10 + 10 x 12 + 12 x 12) mm^2; the 136 mm of rounded edges lack up to 0.6 each.
        self.assertLess(float(box["surface_mm2"]), 768)
        self.assertGreater(float(box["surface_mm2"]), 768 - 0.6 * 136)
        # Blocks of 12 x 10 x 12 mm: one piece; its axes are those of the ellipsoid with its moments.
        self.assertEqual([box[key] for key in ("parts", "tunnels", "cavities", "euler_number")], ["1", "0", "0", "1"])
        for axis, edge in {1: 12, 2: 12, 3: 10}.items():
            self.assertAlmostEqual(float(box[f"axis_{axis}_mm"]), edge * (5 / 3) ** 0.5, places=6)
        self.assertEqual([abs(float(box[f"axis_3_{way}"])) for way in ("left", "posterior", "superior")], [0, 1, 0])
        self.assertAlmostEqual(float(box["sphericity"]), (math.pi * 36 * 1440 ** 2) ** (1 / 3) / float(box["surface_mm2"]), places=6)
        values = [x - 40 for x in range(4)]
        self.assertAlmostEqual(float(wall["mean"]), statistics.mean(values))
        self.assertAlmostEqual(float(wall["standard_deviation"]), statistics.pstdev(values), places=6)
        self.assertEqual((wall["median"], wall["minimum"], wall["maximum"]), ("-38.5", "-40", "-37"))

    def test_a_session_lists_what_was_measured(self):
        session = self.folder / "s.json"
        session.write_text(json.dumps({
            "volumeStudioSession": 1, "volume": {"path": "volume.nrrd"}, "operations": [
                {"op": "measure", "kind": "distance", "points": [[0, 0, 0], [3, 0, 4]]},
                {"op": "measure", "kind": "path", "points": [[0, 0, 0], [3, 0, 0], [3, 4, 0]]},
                {"op": "undo"},
                {"op": "measure", "kind": "angle", "points": [[3, 0, 0], [0, 0, 0], [0, 4, 0]]},
                {"op": "measure", "kind": "area", "points": [[5.5, 4.5, 8], [17.5, 4.5, 8], [17.5, 14.5, 8], [5.5, 14.5, 8]]}]}))
        table = self.folder / "m.csv"
        result = call("stats", session, "--measurements", table)
        self.assertEqual(result.returncode, 0, result)
        lines = result.stdout.splitlines()
        self.assertEqual(len(lines), 4, result.stdout)
        self.assertIn("6.7 mm", lines[1])
        self.assertIn("90.0\u00b0", lines[2])
        self.assertIn("120 mm\u00b2", lines[3])
        self.assertIn("200 \u00b1 0", lines[3])
        with open(table, newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([(row["kind"], row["unit"]) for row in rows], [("distance", "mm"), ("angle", "degrees"), ("area", "mm2")])
        self.assertAlmostEqual(float(rows[0]["value"]), math.hypot(3, 6), places=8)
        self.assertEqual((rows[2]["voxels"], rows[2]["mean"], rows[2]["standard_deviation"]), ("120", "200", "0"))
        self.assertEqual(rows[0]["points_lps_mm"], "0 0 0; 3 0 6")
        labels = self.labels("l.nrrd", in_box)
        self.refused(2, ["--measurements", "session"], "stats", labels, "--volume", self.volume, "--measurements", table)
        session.write_text(json.dumps({"volumeStudioSession": 1, "volume": {"path": "volume.nrrd"}, "operations": [
            {"op": "measure", "kind": "area", "points": [[5, 4, 8], [7, 4, 9], [7, 4.5, 7]]}]}))
        self.refused(1, ["operation 1", "points", "one slice"], "stats", session)

    def test_values_that_are_no_numbers_are_left_out(self):
        self.volume = write_nrrd(self.folder / "floats.nrrd",
                                 lambda v: float("nan") if v[2] < 4 else 0.25 * v[0], "float", "f")
        lines, rows = self.stats(self.labels("l.nrrd", lambda v: 1 if v[2] < 4 else 2 if v[0] < 3 else 0))
        self.assertEqual((rows[0]["finite_voxels"], rows[0]["mean"], rows[0]["median"]), ("0", "", ""))
        self.assertEqual((rows[1]["mean"], rows[1]["median"], rows[1]["maximum"]), ("0.25", "0.25", "0.5"))
        self.assertIn(" - ", lines[1])

    def test_whole_numbers_may_come_as_floats(self):
        # Some programs write label maps so, and 64-bit ones are read so.
        _, rows = self.stats(self.labels("l.nrrd", lambda v: 7 if in_box(v) else 0, "float", "f"))
        self.assertEqual([row["label"] for row in rows], ["7"])

    def test_wrong_input_is_refused_in_one_line(self):
        good = self.labels("good.nrrd", lambda v: in_box(v))
        stats = ("--volume", self.volume)
        self.refused(2, ["--volume"], "stats", good)
        self.refused(1, ["gone.nrrd"], "stats", self.folder / "gone.nrrd", *stats)
        self.refused(1, ["gone.nrrd"], "stats", good, "--volume", self.folder / "gone.nrrd")
        self.refused(2, ["t.txt", ".csv"], "stats", good, *stats, "--csv", self.folder / "t.txt")
        self.refused(1, ["nowhere"], "stats", good, *stats, "--csv", self.folder / "nowhere" / "t.csv")
        half = self.labels("half.nrrd", lambda v: 0.5, "float", "f")
        self.refused(1, ["half.nrrd", "0.5", "whole numbers"], "stats", half, *stats)
        many = self.labels("many.nrrd", lambda v: v[0] + 24 * v[1], "uint16", "H")
        self.refused(1, ["many.nrrd", "255"], "stats", many, *stats)
        raw = self.folder / "labels.raw"
        raw.write_bytes(bytes(24 * 20 * 16))
        self.refused(1, ["labels.raw", "NRRD"], "stats", raw, *stats)  # --raw describes the volume
        none = self.labels("none.nrrd", lambda v: 0)
        self.refused(1, ["none.nrrd", "no label"], "stats", none, *stats)
        small = self.labels("small.nrrd", lambda v: 1, dims=(24, 20, 15))
        self.refused(1, ["small.nrrd", "24 x 20 x 15", "24 x 20 x 16", "volume.nrrd"], "stats", small, *stats)
        for name, grid in {"wide.nrrd": {"spacing": (1, 1, 1.6)}, "aside.nrrd": {"origin": (0, 0.5, 0)}}.items():
            other = self.labels(name, lambda v: 1, **grid)
            self.refused(1, [name, "volume.nrrd", "spacing"], "stats", other, *stats)
        rounded = self.labels("rounded.nrrd", lambda v: in_box(v), spacing=(1.00001, 1, 1.5), origin=(0.001, 0, 0))
        self.assertEqual(call("stats", rounded, *stats).returncode, 0, "headers round")

    def grow(self, compare):
        return ("grow", self.volume, "--seed", "10,10,8", "--range", "100:255", "-o", self.folder / "grown.nrrd",
                "--compare", compare)

    def agreement(self, compare):
        result = call(*self.grow(compare))
        self.assertEqual(result.returncode, 0, result.stderr)
        return {key: float(value) for key, value in (line.split()[:2] for line in result.stdout.splitlines())}

    def test_growth_is_compared_with_the_truth(self):
        truth = self.labels("truth.nrrd", lambda v: (4 if v[2] < 8 else 9) if in_box(v) else 2 if v[0] == 0 else 0)
        for compare in (f"{truth}:4,9", self.labels("same.nrrd", lambda v: in_box(v))):
            same = self.agreement(compare)
            self.assertEqual((same["dice"], same["jaccard"], same["hausdorff_95_mm"]), (1, 1, 0))
            self.assertEqual((same["volume_difference_ml"], same["volume_difference_percent"]), (0, 0))
        half = self.agreement(f"{truth}:4")
        self.assertAlmostEqual(half["dice"], 2 / 3, places=5)
        # The upper face, 120 of 960 - 480 = 480 border voxels, is four slices of 1.5 mm away.
        self.assertAlmostEqual(half["hausdorff_95_mm"], 6, places=4)
        self.assertEqual((half["volume_difference_ml"], half["volume_difference_percent"]), (0.72, 100))
        self.assertLess(self.agreement(truth)["dice"], 1, "all labels, the wall too")

    def test_growth_refuses_a_wrong_truth_before_it_grows(self):
        truth = self.labels("truth.nrrd", lambda v: 4 if in_box(v) else 0)
        self.refused(2, ["--compare", "'x'", "labels.nii.gz:4,5"], *self.grow(f"{truth}:x"))
        self.refused(2, ["--compare"], *self.grow(f"{truth}:4,"))
        self.refused(1, ["truth.nrrd", "label 5", "there are 4"], *self.grow(f"{truth}:4,5"))
        self.refused(1, ["gone.nrrd"], *self.grow(self.folder / "gone.nrrd"))
        small = self.labels("small.nrrd", lambda v: 1, dims=(24, 20, 15))
        self.refused(1, ["small.nrrd", "24 x 20 x 16"], *self.grow(small))
        self.assertFalse((self.folder / "grown.nrrd").exists())

    def test_real_labels(self):
        if not DATA.is_dir():
            print(f"skipped: no test data at {DATA}", flush=True)
            self.skipTest("no test data")
        self.volume = DATA / "colin27_t1_head.nii.gz"
        _, rows = self.stats(DATA / "colin27_tissue_labels.nii.gz")
        # Counts and grey and white matter's values stand in the data's own description.
        self.assertEqual([int(row["voxels"]) for row in rows], [1457090, 498234, 308195, 990129, 660550, 126292])
        for row, mean, deviation in ((rows[3], 83, 12), (rows[4], 109, 7)):
            self.assertAlmostEqual(float(row["mean"]), mean, delta=0.5)
            self.assertAlmostEqual(float(row["standard_deviation"]), deviation, delta=0.5)


if __name__ == "__main__":
    unittest.main(verbosity=2)
