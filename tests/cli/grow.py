#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compares vstudio grow, under all its rules, with a plain queue. usage: grow.py VSTUDIO"""
import collections
import gzip
import itertools
import json
import math
import os
import pathlib
import random
import struct
import subprocess
import sys
import tempfile
import unittest

VSTUDIO = sys.argv.pop(1)
DIMS = (13, 11, 9)
SPACING = (0.5, 1, 2)  # powers of two: gradients of whole numbers squared are the same in float and double
VOXELS = [(x, y, z) for z in range(DIMS[2]) for y in range(DIMS[1]) for x in range(DIMS[0])]
STEPS = [step for step in itertools.product((-1, 0, 1), repeat=3) if any(step)]
SEED = (6, 5, 4)


def call(*arguments):
    return subprocess.run([VSTUDIO, *map(os.fspath, (a if isinstance(a, os.PathLike) else str(a) for a in arguments))],
                          capture_output=True, text=True, timeout=300)


def write_nrrd(path, values, kind="uint8", code="B", dims=DIMS):
    header = (f"NRRD0004\ntype: {kind}\ndimension: 3\nspace: left-posterior-superior\nsizes: {dims[0]} {dims[1]} {dims[2]}\n"
              f"space directions: ({SPACING[0]},0,0) (0,{SPACING[1]},0) (0,0,{SPACING[2]})\nkinds: domain domain domain\n"
              "endian: little\nencoding: raw\nspace origin: (0,0,0)\n\n")
    path.write_bytes(header.encode() + struct.pack(f"<{len(values)}{code}", *values))
    return path


def read_nrrd(path):
    header, data = path.read_bytes().split(b"\n\n", 1)
    code = {b"uint8": "B", b"int16": "h", b"short": "h", b"uint32": "I", b"unsigned int": "I", b"unsigned char": "B"}
    kind = next(line[6:] for line in header.splitlines() if line.startswith(b"type: "))
    data = gzip.decompress(data) if b"encoding: gzip" in header else data
    return list(struct.unpack(f"<{len(VOXELS)}{code[kind]}", data))


def lies_in(value, bounds):
    return bounds is None or bounds[0] <= value <= bounds[1]


class Grow(unittest.TestCase):
    def setUp(self):
        self.holder = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.holder.name)
        dice = random.Random(5)
        values = [dice.randint(-20, 20) for _ in VOXELS]
        self.values = dict(zip(VOXELS, values))
        for axis, shift in itertools.product(range(3), (-1, 0, 1)):  # the seed's gradient is 4
            self.values[tuple(s + shift * (a == axis) for a, s in enumerate(SEED))] = 2 * shift * (axis == 0)
        values = list(self.values.values())
        self.volume = write_nrrd(self.folder / "volume.nrrd", values, "int16", "h")
        self.inside = {v: dice.randint(0, 4) for v in VOXELS}  # a fifth is outside
        self.inside[SEED] = 1
        self.mask = write_nrrd(self.folder / "mask.nrrd", list(self.inside.values()))
        self.others = {v: dice.choice((0, 0, 0, 0, 1, 2, 700)) for v in VOXELS}
        self.others[SEED] = 0
        self.labels = write_nrrd(self.folder / "others.nrrd", list(self.others.values()), "int16", "h")
        self.output = self.folder / "grown.nrrd"

    def tearDown(self):
        self.holder.cleanup()

    def gradient(self, voxel):
        squared = 0.0
        for axis in range(3):
            before, after = list(voxel), list(voxel)
            before[axis] = max(voxel[axis] - 1, 0)
            after[axis] = min(voxel[axis] + 1, DIMS[axis] - 1)
            squared += ((self.values[tuple(after)] - self.values[tuple(before)]) / (2 * SPACING[axis])) ** 2
        return math.sqrt(squared)

    def queue(self, rules):
        """What grows: generations by voxel."""
        gradients = {v: self.gradient(v) for v in VOXELS}

        def is_free(voxel):
            return (lies_in(self.values[voxel], rules["range"]) and lies_in(gradients[voxel], rules.get("gradient")) and
                    ("inside" not in rules or self.inside[voxel] != 0) and
                    ("labels-in" not in rules or self.others[voxel] == 0))

        generations = {SEED: 1}
        waiting = collections.deque([SEED])
        while waiting:
            parent = waiting.popleft()
            for step in STEPS:
                child = tuple(a + b for a, b in zip(parent, step))
                if (rules["connectivity"] == 6 and sum(map(abs, step)) > 1) or child in generations or child not in self.values:
                    continue
                if (is_free(child) and lies_in(self.values[child] - self.values[parent], rules.get("difference")) and
                        lies_in(gradients[child] - gradients[parent], rules.get("gradient-difference"))):
                    generations[child] = generations[parent] + 1
                    waiting.append(child)
        return generations

    def arguments(self, rules, *more):
        arguments = ["grow", self.volume, "--seed", ",".join(map(str, SEED)), "-o", self.output, *more]
        for name, value in rules.items():
            text = {"inside": self.mask, "labels-in": self.labels}.get(name, value)
            arguments += [f"--{name}", f"{text[0]}:{text[1]}" if isinstance(text, tuple) else text]
        return arguments

    def test_every_rule_and_their_combinations_are_a_plain_queues(self):
        # Ends of gradients lie between the values that occur, so that rounding decides nothing.
        rules = {"difference": (-6, 9), "gradient": (0, 22.0123), "gradient-difference": (-7.0123, 8.0123), "inside": True,
                 "labels-in": True}
        cases = [c for n in (1, 2, 5) for c in itertools.combinations(rules, n)]
        sizes = set()
        for case, connectivity in itertools.product([(), *cases], (6, 26)):
            chosen = {"range": (-15, 18), "connectivity": connectivity, **{name: rules[name] for name in case}}
            with self.subTest(chosen):
                generations = self.folder / "generations.nrrd"
                result = call(*self.arguments(chosen, "--generations", generations))
                self.assertEqual(result.returncode, 0, result.stderr)
                expected = self.queue(chosen)
                self.assertEqual(read_nrrd(generations), [expected.get(v, 0) for v in VOXELS])
                own, others = (3, self.others) if "labels-in" in case else (1, dict.fromkeys(VOXELS, 0))
                self.assertEqual(read_nrrd(self.output), [own if v in expected else others[v] for v in VOXELS])
                sizes.add(len(expected))
        self.assertGreater(len(sizes), len(cases) // 2, "the rules differ")

    def test_negative_ranges_are_written_with_a_space_or_without(self):
        written = []
        for words in (["--difference", "-6:9"], ["--difference=-6:9"]):
            result = call(*self.arguments({"range": (-15, 18)}), *words)
            self.assertEqual(result.returncode, 0, result.stderr)
            written.append(read_nrrd(self.output))
        self.assertEqual(written[0], written[1])

    def refused(self, code, mentions, *arguments):
        result = call(*arguments)
        self.assertEqual((result.returncode, result.stderr.count("\n")), (code, 1), result)
        for text in mentions:
            self.assertIn(text, result.stderr)
        self.assertFalse(self.output.exists())

    def test_wrong_input_is_refused_in_one_line(self):
        grow = self.arguments({"range": (-15, 18)})
        for option in ("--difference", "--gradient", "--gradient-difference"):
            self.refused(2, [option, "'5:-5'", "-5:5"], *grow, option, "5:-5")
        self.refused(2, ["--gradient", "-5:-1"], *grow, "--gradient", "-5:-1")
        small = write_nrrd(self.folder / "small.nrrd", [1] * (13 * 11 * 8), dims=(13, 11, 8))
        for option in ("--inside", "--labels-in"):
            self.refused(1, ["small.nrrd", "13 x 11 x 8"], *grow, option, small)
            self.refused(1, ["gone.nrrd"], *grow, option, self.folder / "gone.nrrd")
        self.refused(2, ["--inside", "'x'"], *grow, "--inside", f"{self.mask}:x")
        self.refused(1, ["6,5,4", "gradient", "900:1000"], *grow, "--gradient", "900:1000")
        self.refused(1, ["6,5,4", "outside", "mask.nrrd"], *grow, "--inside", f"{self.mask}:2")
        everywhere = write_nrrd(self.folder / "all.nrrd", [4] * len(VOXELS))
        self.refused(1, ["6,5,4", "segment 4", "all.nrrd"], *grow, "--labels-in", everywhere)

    def test_some_seeds_in_another_segment_are_left_out_with_a_note(self):
        taken = next(v for v in VOXELS if self.others[v] == 700)
        result = call(*self.arguments({"range": (-15, 18), "labels-in": True}, "--seed", ",".join(map(str, taken))))
        self.assertEqual((result.returncode, result.stderr.count("\n")), (0, 1), result.stderr)
        self.assertIn("1 of 2 seeds", result.stderr)
        self.assertIn("segment 700", result.stderr)
        self.assertEqual(read_nrrd(self.output)[VOXELS.index(taken)], 700)

    def test_a_sessions_segments_are_measured_as_its_label_map(self):
        session = self.folder / "session.json"
        seed = {"op": "seed", "strokes": [], "range": [-15, 18]}
        session.write_text(json.dumps({"volumeStudioSession": 1, "volume": {"path": "volume.nrrd"}, "operations": [
            {"op": "segment", "segment": "Segment 1", "name": "kernel", "colour": [1, 0, 0]},
            {**seed, "voxels": [SEED]}, {"op": "grow", "generations": 2},
            {"op": "segment", "segment": "rest", "colour": [0, 0, 1]},
            {**seed, "voxels": [next(v for v in VOXELS if lies_in(self.values[v], (-15, 18)))]}, {"op": "grow"},
            {"op": "labels", "file": "labels.nrrd"}, {"op": "picture", "file": "p.png", "size": [32, 24]}]}))
        table = self.folder / "t.csv"
        before = set(self.folder.iterdir())
        result = call("stats", session, "--csv", table)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(set(self.folder.iterdir()) - before, {table}, "the session's own files are not written")
        rows = [line.split(",") for line in table.read_text().splitlines()]
        self.assertEqual([row[1] for row in rows[1:]], ["kernel", "rest"])
        self.assertEqual([row[2] for row in rows[1:]], ["#FF0000", "#0000FF"])
        self.assertEqual(call("run", session, "-o", self.folder).returncode, 0)
        call("stats", self.folder / "labels.nrrd", "--volume", self.volume, "--csv", self.folder / "u.csv")
        labels = [line.split(",") for line in (self.folder / "u.csv").read_text().splitlines()]
        self.assertEqual([row[3:] for row in rows], [row[3:] for row in labels])
        self.assertEqual(call("stats", session, "--volume", self.volume).stdout, result.stdout)


if __name__ == "__main__":
    unittest.main(verbosity=2)
