#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Calls `vstudio bench` on a tiny volume, and checks how bench/compare sums up and bench/compare_baseline judges.
usage: bench.py VSTUDIO BENCH_FOLDER"""
import importlib.machinery
import importlib.util
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

BENCH = pathlib.Path(sys.argv.pop(2))
VSTUDIO = sys.argv.pop(1)
sys.dont_write_bytecode = True
sys.path.insert(0, str(BENCH))
from peers import report  # noqa: E402

MODES = {"surface", "mip", "xray", "overlay", "segment"}


def load(program):
    loader = importlib.machinery.SourceFileLoader(program, str(BENCH / program))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader(program, loader))
    loader.exec_module(module)
    return module


class Bench(unittest.TestCase):
    def setUp(self):
        self.holder = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.holder.name)
        self.raw = self.folder / "box.raw"
        self.raw.write_bytes(bytes(200 if 6 <= x < 18 and 5 <= y < 15 and 4 <= z < 12 else x
                                   for z in range(16) for y in range(20) for x in range(24)))
        self.json = self.folder / "bench.json"

    def tearDown(self):
        self.holder.cleanup()

    def bench(self, *arguments):
        usual = {"--raw": "24x20x16:uint8", "--range": "100:255", "--size": "64x48", "--frames": "2"}
        options = [text for pair in usual.items() if pair[0] not in arguments for text in pair]
        return subprocess.run([VSTUDIO, "bench", self.raw, "--json", self.json, *options, *arguments],
                              capture_output=True, text=True, timeout=300)

    def measure(self, *arguments):
        result = self.bench(*arguments)
        self.assertEqual(result.returncode, 0, result.stderr)
        return result.stdout, json.loads(self.json.read_text(encoding="utf-8"))

    def refused(self, mentions, *arguments):
        result = self.bench(*arguments)
        self.assertEqual(result.returncode, 2, result)
        self.assertEqual(len(result.stderr.splitlines()), 1, result.stderr)
        self.assertIn(mentions, result.stderr)
        self.assertFalse(self.json.exists())

    def test_everything_is_measured_and_takes_time(self):
        table, data = self.measure()
        self.assertEqual(data["size"], [64, 48])
        self.assertTrue(data["device"]["renderer"])
        (volume,) = data["volumes"]
        self.assertEqual(volume["dims"], [24, 20, 16])
        self.assertEqual(volume["range"], [100, 255])
        entries = {entry["name"]: entry for entry in volume["entries"]}
        self.assertLessEqual(MODES | {"read file", "upload", "histogram", "cell ranges", "macrocells", "drill stamp",
                                      "peel step", "grow 50 generations"}, set(entries))
        self.assertLessEqual(MODES, {entry["name"] for entry in volume["entries"] if entry["kind"] == "mode"})
        for name, entry in entries.items():
            self.assertEqual(len(entry["milliseconds"]), 2, name)
            self.assertTrue(all(time > 0 for time in entry["milliseconds"]), name)
            self.assertAlmostEqual(entry["medianMilliseconds"], sum(entry["milliseconds"]) / 2)
            self.assertIn(name, table)

    def test_passes_are_named_and_timed_by_the_device(self):
        _, data = self.measure("--parts", "modes", "--modes", "surface")
        (entry,) = data["volumes"][0]["entries"]
        self.assertEqual(entry["passes"]["resolve picture"]["count"], 1)
        for name, times in entry["passes"].items():
            self.assertGreater(times["deviceMilliseconds"], 0, name)
        self.assertAlmostEqual(entry["deviceMilliseconds"],
                               sum(times["deviceMilliseconds"] for times in entry["passes"].values()))

    def test_only_what_is_asked_for_is_measured(self):
        _, data = self.measure("--parts", "modes", "--modes", "mip,surface", "--orbit=-30,60:-10.5")
        self.assertEqual([entry["name"] for entry in data["volumes"][0]["entries"]], ["mip", "surface"])
        self.assertEqual((data["azimuths"], data["elevation"]), ([-30, 60], -10.5))

    def test_a_range_that_shows_nothing_leaves_the_edits_out(self):
        self.raw.write_bytes(bytes(24 * 20 * 16))
        _, data = self.measure("--parts", "edits")
        self.assertEqual(data["volumes"][0]["entries"], [])

    def test_live_strokes_are_timed(self):
        _, data = self.measure("--parts", "strokes,edits")
        names = [entry["name"] for entry in data["volumes"][0]["entries"]]
        self.assertEqual(names[-6:], ["drill pen-down", "drill stamp", "drill pen-up", "peel, first layer",
                                      "peel, drawn down", "peel, drawn up"])

    def test_bad_options_are_refused_in_one_line(self):
        self.refused("mode 'volumetric'", "--modes", "surface,volumetric")
        self.refused("--parts", "--parts", "data,pictures")
        self.refused("--orbit '0,90'", "--orbit", "0,90")
        self.refused("--orbit '0,x'", "--orbit", "0,x:15")
        self.refused("--frames: Value 0", "--frames", "0")
        self.refused("size '0x5'", "--size", "0x5")
        self.refused("range '9:1'", "--range", "9:1")
        self.refused("24y20", "--raw", "24y20")


class Comparison(unittest.TestCase):
    def test_the_ratio_is_to_the_faster_peer(self):
        result = report.summarise({"a": {"mip": {"vstudio": [10, 11, 900], "vtk cpu": [44], "vtk gpu": [22, 22]}}})
        (row,) = result["rows"]
        self.assertEqual((row["medians"]["vstudio"], row["fasterPeer"], row["ratio"]), (11, "vtk gpu", 2))
        self.assertEqual(row["frames"], {"vstudio": 3, "vtk cpu": 1, "vtk gpu": 2})

    def test_means_are_geometric_and_per_mode(self):
        times = {"a": {"mip": {"vstudio": [10], "vtk cpu": [40]}, "surface": {"vstudio": [10], "vtk cpu": [30]}},
                 "b": {"mip": {"vstudio": [10], "vtk cpu": [10]}}}
        means = report.summarise(times)["geometricMeans"]
        self.assertAlmostEqual(means["mip"], 2)
        self.assertAlmostEqual(means["surface"], 3)

    def test_the_table_leaves_open_what_was_not_measured(self):
        times = {"a": {"mip": {"vstudio": [10], "vtk cpu": [40], "vtk gpu": [50]}},
                 "b": {"mip": {"vstudio": [10], "vtk cpu": [10]}}}
        table = report.markdown({**report.summarise(times), "size": [64, 48]})
        self.assertIn("| mip | a | 10.0 | 40.0 | 50.0 | 4.00 |", table)
        self.assertIn("| mip | b | 10.0 | 10.0 |  | 1.00 |", table)

    def test_the_transfer_function_spans_the_range_and_ends_there(self):
        scene = json.loads((BENCH / "scene.json").read_text(encoding="utf-8"))
        points = load("compare").transfer_function(scene, (100, 300))["points"]
        self.assertEqual([(point["at"], point["opacity"]) for point in points],
                         [(100, 0), (100, 0), (150, 0.3), (300, 0.3), (300, 0)])
        self.assertEqual((points[0]["colour"], points[-1]["colour"]), ("#8c4026", "#fff5e6"))


class Baseline(unittest.TestCase):
    """bench/compare_baseline, by times that were made up."""

    def setUp(self):
        self.program = load("compare_baseline")

    def summary(self, taken, loop=(100,) * 9, device="a device"):
        times = {"peel": {"milliseconds": list(taken), "calibration": list(loop)}}
        return self.program.summarise({"device": device, "processors": 2, "stages": times})

    def row(self, before, now):
        rows = self.program.compare(before, now)
        self.assertEqual([row["name"] for row in rows], ["peel"])
        return rows[0]

    def test_times_are_multiples_of_the_loop(self):
        stage = self.summary([40, 80, 20] * 3, [100, 200, 50] * 3)["stages"]["peel"]
        self.assertEqual((stage["multiple"], stage["spread"], stage["milliseconds"]), (0.4, 0, 40))

    def test_a_machine_that_is_busy_is_not_slower(self):
        self.assertFalse(self.row(self.summary([40] * 9), self.summary([120] * 9, [300] * 9))["slower"])

    def test_a_stage_that_takes_longer_is_slower(self):
        self.assertFalse(self.row(self.summary([40] * 9), self.summary([43] * 9))["slower"])
        row = self.row(self.summary([40] * 9), self.summary([46] * 9))
        self.assertTrue(row["slower"])
        self.assertAlmostEqual(row["ratio"], 1.15)
        self.assertFalse(self.row(self.summary([46] * 9), self.summary([40] * 9))["slower"])

    def test_noise_hides_what_is_smaller_than_it(self):
        noisy = [30, 34, 36, 38, 40, 42, 44, 46, 50]
        for before, now in ((noisy, [46] * 9), ([40] * 9, [1.15 * time for time in noisy])):
            self.assertFalse(self.row(self.summary(before), self.summary(now))["slower"], (before, now))
        self.assertTrue(self.row(self.summary(noisy), self.summary([80] * 9))["slower"])

    def test_one_round_that_was_held_up_says_nothing(self):
        self.assertFalse(self.row(self.summary([40] * 9), self.summary([40] * 8 + [4000]))["slower"])

    def test_another_device_or_other_stages_are_not_compared(self):
        here = self.summary([40] * 9)
        self.assertEqual(self.program.difference(here, here), "")
        self.assertIn("a device", self.program.difference(here, self.summary([40] * 9, device="another")))
        self.assertIn("peel", self.program.difference({**here, "stages": {}}, here))

    def test_the_baseline_is_of_the_stages_that_are_measured(self):
        baseline = json.loads((BENCH / "baseline.json").read_text(encoding="utf-8"))
        source = (BENCH / "stages" / "stages.cpp").read_text(encoding="utf-8")
        self.assertGreater(len(baseline["stages"]), 5)
        for name, stage in baseline["stages"].items():
            self.assertIn(f'"{name}"', source)
            self.assertGreater(stage["multiple"], 0)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], "-v"])
