#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What is done to a store that is worked on at a coarser level than its finest is what is done to that one: sculptures, what is left of
the volume, and sessions that were made on another level.

usage: finer.py VSTUDIO
"""
import gzip
import json
import re
import subprocess
import sys
import unittest

from scan_case import ScanCase, libraries

numpy, zarr = libraries("numpy", "zarr")

SHAPE = (128, 160, 192)  # z, y, x
CUTS = [
    {"op": "view", "range": [60, 255], "camera": {"azimuth": 25, "elevation": 30}},
    {"op": "scissors", "outline": {"shape": "ellipse", "points": [[500, 180], [560, 240]]}},
    {"op": "drill", "depthMax": 14, "mask": {"shape": "circle", "points": [[640, 330], [665, 330]]},
     "stroke": [[640, 330, 0.5], [700, 380, 1]]},
    {"op": "laser", "depthMax": 12, "mask": {"shape": "circle", "points": [[560, 430], [580, 430]]}, "stroke": [[560, 430, 1], [600, 470, 1]]},
    {"op": "peel", "layers": 5, "mask": {"shape": "ellipse", "points": [[680, 480], [760, 560]]}},
    {"op": "sweep", "mask": {"shape": "circle", "points": [[0, 0], [6, 0]]},
     "path": {"kind": "spline", "points": [[60, 40, 100], [96, 30, 110], [130, 50, 90]]}},
    {"op": "clip", "box": [[20, 10, 16], [170, 150, 120]]},
]
GROWTH = [
    {"op": "view", "range": [60, 255], "camera": {"azimuth": 25, "elevation": 30}},
    CUTS[2],
    {"op": "seed", "range": [85, 255], "voxels": [[66, 80, 64]]}, {"op": "grow", "generations": 30},
    {"op": "growth rules", "range": [90, 240], "difference": [-60, 60], "live": True}, {"op": "grow", "generations": 50},
    {"op": "absorb", "voxels": [[66, 80, 64]], "expansions": 12}, {"op": "rewind", "generations": 5},
    {"op": "segment", "segment": "Skin"},
    {"op": "seed", "range": [40, 84], "voxels": [[94, 74, 30], [115, 18, 64]]}, {"op": "grow", "generations": 40},
    {"op": "show generation", "generation": 30}, {"op": "undo"}, {"op": "undo"}, {"op": "redo"},
]
# Edits of the whole, and a ball's way. Voxels of islands and places of brushes are the finest level's.
SHAPES = GROWTH + [
    {"op": "edit segment", "edit": "smooth", "amount": 1.2}, {"op": "edit segment", "edit": "open", "amount": 0.9},
    {"op": "segment", "segment": "Segment 1"},
    {"op": "edit segment", "edit": "drop small", "amount": 0.01}, {"op": "edit segment", "edit": "fill holes"},
    {"op": "edit segment", "edit": "margin", "amount": 1.7}, {"op": "edit segment", "edit": "close", "amount": 2.3}, {"op": "undo"},
    {"op": "edit segment", "edit": "subtract", "other": "Skin", "amount": 1},
    {"op": "paint segment", "trail": {"points": [[60.2, 70.1, 60.4], [80, 90, 70], [100.6, 70, 66]], "radius": 4.3}, "range": [30, 255], "adds": True},
    {"op": "paint segment", "trail": {"points": [[70, 80, 64], [72, 84, 66]], "radius": 3.1}, "adds": False},
    {"op": "edit segment", "edit": "keep island", "voxel": [60, 70, 60]},
    {"op": "brush segment", "adds": False, "stroke": CUTS[3]}, {"op": "brush segment", "adds": True, "stroke": CUTS[3]}, {"op": "undo"},
]
SEED = [{"op": "seed", "range": [85, 255], "voxels": [[66, 80, 64]]}, {"op": "grow"}]
HALF_SEED = [{"op": "seed", "range": [85, 255], "voxels": [[33, 40, 32]]}, {"op": "grow"}]


def read_nrrd(path):
    """Values (z, y, x) of bytes that vstudio wrote."""
    header, data = path.read_bytes().split(b"\n\n", 1)
    fields = dict(line.split(": ", 1) for line in header.decode().split("\n") if ": " in line)
    data = gzip.decompress(data) if fields["encoding"] == "gzip" else data
    return numpy.frombuffer(data, "u1").reshape([int(n) for n in fields["sizes"].split()][::-1])


class Finer(ScanCase):
    def store(self):
        path = self.folder / "head.zarr"
        self.succeed("phantom", "head", "--size", "x".join(map(str, SHAPE[::-1])), "-o", path, "--noise", "2")
        return path

    def session(self, name, store, operations, **volume):
        path = self.folder / name
        path.write_text(json.dumps({"volumeStudioSession": 1, "volume": {"path": str(store), **volume}, "operations": operations}))
        return path

    def run_session(self, session, out, *options):
        done = self.succeed("run", session, "-o", self.folder / out, *options)
        return self.folder / out, json.loads((self.folder / out / "report.json").read_text()), done.stderr

    def values(self, path):
        return zarr.open_group(str(path), "r")["0"][:]

    def test_a_session_cuts_the_finest_level_whatever_it_is_replayed_on(self):
        outputs = [{"op": "picture", "file": "p.png", "size": [615, 435], "samples": 4}, {"op": "sculpture", "file": "s.zarr"}]
        session = self.session("s.json", self.store(), CUTS + outputs)
        dense, report, said = self.run_session(session, "dense", "--level", 0)
        self.assertEqual((report["level"], report["storage"]), (0, "dense"))
        self.assertNotIn("replayed on level", said)
        wanted = self.values(dense / "s.zarr")
        self.assertGreater((wanted > 0.5).mean(), 0.3)
        for level in (1, 2):
            with self.subTest(level=level):
                bricks, report, said = self.run_session(session, f"bricks{level}", "--level", level)
                self.assertEqual((report["level"], report["storage"]), (level, "bricks"))
                self.assertIn(f"made on level 0 and is replayed on level {level}", said)
                cut = self.values(bricks / "s.zarr")
                self.assertEqual(cut.shape, SHAPE)
                # What tools find on surfaces is found in another voxel space, and rounded there.
                off = numpy.abs(cut - wanted) > 0.02
                self.assertLess(off.mean(), 2e-4)
                most, mean = map(float, re.search(r"max (\d+) mean ([\d.]+)",
                                                  self.call("compare", dense / "p.png", bricks / "p.png").stdout).groups())
                self.assertLess(mean, 1.0)

    def test_segments_grow_at_the_finest_level_whatever_is_worked_on(self):
        session = self.session("s.json", self.store(), GROWTH + [{"op": "labels", "file": "l.zarr"}, {"op": "labels", "file": "l.nrrd"}])
        wanted = {}
        for level in (0, 1, 2):
            with self.subTest(level=level):
                out, report, _ = self.run_session(session, str(level), "--level", level)
                grown = self.values(out / "l.zarr"), [o["message"] for o in report["operations"] if o["name"] in ("grow", "rewind", "absorb")]
                self.assertEqual(grown[0].shape, SHAPE)
                wanted = wanted or grown
                self.assertGreater((grown[0] == 1).sum(), 10_000)
                self.assertGreater((grown[0] == 2).sum(), 1_000)
                # Where and when all voxels joined is the same, to the byte.
                self.assertTrue(numpy.array_equal(grown[0], wanted[0]))
                self.assertEqual(grown[1], wanted[1])

    def test_segments_get_their_shape_at_the_finest_level_whatever_is_worked_on(self):
        session = self.session("s.json", self.store(), SHAPES + [{"op": "labels", "file": "l.zarr"}])
        wanted = {}
        for level in (0, 1, 2):
            with self.subTest(level=level):
                out, report, _ = self.run_session(session, str(level), "--level", level)
                shaped = self.values(out / "l.zarr"), [o["message"] for o in report["operations"] if o["name"].endswith("segment")]
                wanted = wanted or shaped
                for label in (1, 2):
                    self.assertGreater((shaped[0] == label).sum(), 10_000)
                self.assertTrue(numpy.array_equal(shaped[0], wanted[0]), msg=f"{(shaped[0] != wanted[0]).sum()} voxels differ")
                self.assertEqual(shaped[1], wanted[1])

    def test_segments_cut_and_spare_the_finest_level_whatever_is_worked_on(self):
        skin = {"op": "segment", "segment": "Skin", "tools": "spare"}
        steps = {"a segment with a margin": [{"op": "segment", "segment": "Segment 1"}, {"op": "cut segment", "keeps": False, "margin": 1.5}],
                 "all but a segment": [{"op": "segment", "segment": "Segment 1"}, {"op": "cut segment", "keeps": True, "margin": -0.5}],
                 "beside what is spared": [skin, {"op": "segment", "segment": "Segment 1"}, {"op": "cut segment", "keeps": False, "margin": 4}, CUTS[2], CUTS[6]],
                 "what is not connected": [skin, {"op": "keep connected", "voxel": [66, 80, 64]}]}
        store = self.store()
        for number, (what, cuts) in enumerate(steps.items()):
            operations = SHAPES + cuts + [{"op": "sculpture", "file": "s.zarr"}, {"op": "labels", "file": "l.zarr"}]
            session = self.session("s.json", store, operations)
            dense, _, _ = self.run_session(session, f"dense{number}", "--level", 0)
            wanted = self.values(dense / "s.zarr")
            labels = self.values(dense / "l.zarr")
            self.assertGreater((wanted > 0.5).sum(), 10_000, what)
            for level in (1, 2):
                with self.subTest(what=what, level=level):
                    bricks, _, _ = self.run_session(session, f"bricks{number}-{level}", "--level", level)
                    self.assertTrue(numpy.array_equal(self.values(bricks / "l.zarr"), labels))
                    cut = self.values(bricks / "s.zarr")
                    self.assertLess((numpy.abs(cut - wanted) > 0.02).mean(), 2e-4)
                    if skin in cuts:
                        self.assertEqual(((cut >= 0.5) & (labels == 2)).sum(), 0)

    def test_surfaces_are_of_the_finest_level_whatever_is_worked_on(self):
        session = self.session("s.json", self.store(), GROWTH)
        wanted = None
        for level in (0, 1, 2):
            mesh = self.folder / f"{level}.ply"
            said = self.succeed("export", session, "--store-level", level, "-o", mesh, "--smooth", 0).stdout
            said = said.split(":", 1)[1]
            self.assertRegex(said, r"2 surfaces, \d{5,} triangles, [\d.]+ ml")
            wanted = wanted or said  # how many triangles there are, and what they hold
            self.assertEqual(said, wanted)

    def test_label_maps_that_are_stores_are_read_back(self):
        """Of all their levels, with the segments' names."""
        store = self.store()
        named = [{"op": "segment", "segment": "Segment 1", "name": "Bone", "colour": [0.2, 0.4, 0.6]}]
        session = self.session("s.json", store, GROWTH + named + [{"op": "labels", "file": "op.zarr"}])
        out, _, _ = self.run_session(session, "grown", "--level", 1)
        exported = self.folder / "exported.zarr"
        self.succeed("export", session, "--store-level", 1, "-o", exported)
        values = self.values(exported)
        for labels in (out / "op.zarr", exported):
            with self.subTest(labels=labels.name):
                for level in (0, 1):
                    csv = self.folder / "figures.csv"
                    self.succeed("export", labels, "--volume", store, "--store-level", level, "-o", csv)
                    rows = csv.read_text()
                    self.assertIn("Bone", rows)
                    self.assertIn("Skin", rows)
                self.succeed("stats", labels, "--volume", store)
                self.succeed("export", labels, "-o", self.folder / "mesh.stl")
                load = [{"op": "load labels", "path": str(labels)}, {"op": "labels", "file": "l.nrrd"}]
                loaded, _, _ = self.run_session(self.session("l.json", store, load, level=1), f"loaded-{labels.name}", "--storage", "dense")
                again = read_nrrd(loaded / "l.nrrd")
                level1 = zarr.open_group(str(labels), "r")["1"][:]
                self.assertTrue(numpy.array_equal(again != 0, level1 != 0))
        self.assertTrue(numpy.array_equal(values, self.values(out / "op.zarr")))

    def test_label_maps_of_the_finest_level_are_loaded_voxel_by_voxel(self):
        """From a store or a file; what is done to them then is what is done where all of that level is worked on."""
        store = self.store()
        grown, _, _ = self.run_session(
            self.session("s.json", store, GROWTH + [{"op": "labels", "file": "l.nrrd"}, {"op": "labels", "file": "l.zarr"}]), "grown")
        wanted = read_nrrd(grown / "l.nrrd")
        self.assertGreater((wanted == 2).sum(), 1000)
        after = [{"op": "edit segment", "edit": "smooth", "amount": 1.2}, {"op": "cut segment", "keeps": False, "margin": 1}]
        written = [{"op": "labels", "file": "out.zarr"}]
        results = {}
        for labels in ("l.nrrd", "l.zarr"):
            load = [{"op": "load labels", "path": str(grown / labels)}]
            for level in (0, 1):
                with self.subTest(labels=labels, level=level):
                    name = f"{labels}-{level}"
                    out, _, _ = self.run_session(self.session("l.json", store, load + written), name, "--level", level)
                    self.assertTrue(numpy.array_equal(self.values(out / "out.zarr"), wanted))
                    session = self.session("a.json", store, load + after + written)
                    out, _, _ = self.run_session(session, name + "-after", "--level", level)
                    results[labels, level] = self.values(out / "out.zarr")
                    self.assertTrue(numpy.array_equal(results[labels, level], results["l.nrrd", 0]))
        self.assertFalse(numpy.array_equal(results["l.nrrd", 0], wanted))
        for labels in ("l.nrrd", "l.zarr"): # checksums of maps that were read in bricks are known however they are read
            for level in (0, 1):
                load = [{"op": "load labels", "path": str(grown / labels), "checksum": "sets-0123456789abcdef"}]
                self.refuse("is not the label map that was opened", "run", self.session("c.json", store, load), "-o", self.folder / "refused",
                            "--level", level)

    def test_voxels_of_the_finest_level_are_told_to_what_there_is(self):
        """A session that speaks of them alone, where nothing is finer than what is worked on: the scan itself, or a coarser level by itself."""
        store = self.store()
        scan = self.folder / "scan.nrrd"
        self.succeed("reduce", store, "--by", 1, "-o", scan)
        seed = [{"op": "seed", "range": [85, 255], "finest": [[66, 80, 64], [67, 80, 64]]}, {"op": "grow", "generations": 20},
                {"op": "absorb", "finest": [[66, 80, 64]], "expansions": 3}, {"op": "labels", "file": "l.nrrd"}]
        same = [{**op, "voxels": op["finest"], "finest": []} if "finest" in op else op for op in seed]
        wanted = read_nrrd(self.run_session(self.session("v.json", scan, same), "wanted")[0] / "l.nrrd")
        self.assertGreater((wanted > 0).sum(), 1000)
        for name, path, options in (("scan", scan, ()), ("store", store, ()), ("bricks", store, ("--storage", "bricks"))):
            with self.subTest(name=name):
                out, _, _ = self.run_session(self.session("f.json", path, seed), name, *options)
                self.assertTrue(numpy.array_equal(read_nrrd(out / "l.nrrd"), wanted))
        for level in (0, 1):  # that it was made on
            with self.subTest(made=level):
                session = self.session("c.json", store, seed[:2] + seed[3:], **({"level": 1} if level else {}))
                out, report, _ = self.run_session(session, f"coarse{level}", "--level", 1, "--storage", "dense")
                self.assertEqual((report["level"], report["storage"]), (1, "dense"))
                self.assertGreater(read_nrrd(out / "l.nrrd")[32, 40, 33], 0)

    def test_pictures_show_segments_as_they_have_grown(self):
        """Two that touch each other and a cut, as surfaces, over the data and as glass."""
        looks = [{"op": "view", "mode": "overlay"}, {"op": "view", "mode": "segment", "camera": {"azimuth": 160, "elevation": 10}},
                 {"op": "segment", "segment": "Skin", "opacity": 0.4, "work": False}]
        pictures = [op for n, look in enumerate(looks) for op in (look, {"op": "picture", "file": f"{n}.png", "size": [320, 220], "samples": 1})]
        session = self.session("s.json", self.store(), GROWTH + pictures)
        dense, _, _ = self.run_session(session, "dense", "--level", 0)
        off = {}
        for out, options in (("half", ["--level", 1]), ("quarter", ["--level", 2]), ("scene", ["--level", 2, "--storage", "dense"])):
            shown, _, _ = self.run_session(session, out, *options)
            for n in range(len(looks)):
                compared = self.call("compare", dense / f"{n}.png", shown / f"{n}.png").stdout
                off[out, n] = float(re.search(r"mean ([\d.]+)", compared).group(1))
        for n in range(len(looks)):
            for out in ("half", "quarter"):
                # Colours are blended over voxels of the level that is worked on.
                self.assertLess(off[out, n], 1.0, off)
                self.assertLess(off[out, n], 0.5 * off["scene", n], off)

    def test_what_is_worked_on_shows_what_grew_there(self):
        session = self.session("s.json", self.store(), HALF_SEED + [{"op": "labels", "file": "l.zarr"}, {"op": "labels", "file": "l.nrrd"}],
                               level=1)
        out, _, _ = self.run_session(session, "out")
        fine, scene = self.values(out / "l.zarr"), read_nrrd(out / "l.nrrd").astype(int)
        self.assertEqual(scene.shape, tuple(n // 2 for n in SHAPE))
        shares = fine.reshape(scene.shape[0], 2, scene.shape[1], 2, scene.shape[2], 2).sum(axis=(1, 3, 5))
        self.assertTrue((scene[shares >= 4] == 1).all())
        self.assertTrue((scene[shares == 0] == 0).all())
        self.assertLess(abs(scene.sum() * 8 / fine.sum() - 1), 0.1)  # halves count as all

    def test_a_session_of_one_level_grows_on_another_that_is_all_there_is(self):
        store = self.store()
        session = self.session("s.json", store, SEED + [{"op": "labels", "file": "l.zarr"}])
        millilitres = {}
        for level in (0, 1):
            out, report, _ = self.run_session(session, str(level), "--level", level, "--storage", "dense")
            labels = self.values(out / "l.zarr")
            self.assertEqual(labels.shape, tuple(n >> level for n in SHAPE))
            millilitres[level] = (labels > 0).sum() * 8 ** level
        self.assertLess(abs(millilitres[1] / millilitres[0] - 1), 0.05)

    def test_what_is_left_goes_out_as_a_store(self):
        store = self.store()
        session = self.session("s.json", store, CUTS, level=1)
        for out, options, shape in (("fine.zarr", (), SHAPE), ("coarse.zarr", ("--storage", "dense"), tuple(n // 2 for n in SHAPE))):
            with self.subTest(out=out):
                self.succeed("export", session, "--what", "volume", "-o", self.folder / out, "--fill", 7, *options)
                left = self.values(self.folder / out)
                self.assertEqual(left.shape, shape)
                whole = zarr.open_group(str(store), "r")["0" if shape == SHAPE else "1"][:]
                self.assertGreater((left == 7).mean(), 0.3)
                self.assertGreater((left == whole).mean(), 0.2)
        group = zarr.open_group(str(self.folder / "fine.zarr"), "r")
        self.assertGreater(len(group.attrs["multiscales"][0]["datasets"]), 1)
        # And it opens here, where it lies.
        self.assertIn("192 x 160 x 128", self.succeed("info", self.folder / "fine.zarr").stdout)

    def test_labels_go_out_as_a_store_with_names_and_colours(self):
        session = self.session("s.json", self.store(), [{"op": "segment", "segment": "Brain", "colour": [1, 0.5, 0]}] + SEED)
        self.succeed("export", session, "-o", self.folder / "l.zarr")
        group = zarr.open_group(str(self.folder / "l.zarr"), "r")
        look = group.attrs["image-label"]
        self.assertEqual(look["properties"], [{"label-value": 1, "name": "Brain"}])
        self.assertEqual(look["colors"], [{"label-value": 1, "rgba": [255, 128, 0, 255]}])
        self.assertEqual(set(numpy.unique(group["0"][:])), {0, 1})
        session = self.session("c.json", self.folder / "head.zarr", HALF_SEED, level=1)
        self.succeed("export", session, "-o", self.folder / "c.zarr")
        # All of a voxel of the scene that the rules let in is seeded: the same grows in the end.
        self.assertTrue(numpy.array_equal(self.values(self.folder / "c.zarr"), group["0"][:]))
        self.assertEqual(set(numpy.unique(group["1"][:])), {0, 1})

    def test_pictures_on_a_busy_machine_are_those_of_an_idle_one(self):
        """Bricks come while rays are cast again for those that came before."""
        view = {"op": "view", "range": [60, 255], "mode": "mip", "camera": {"azimuth": 25, "elevation": 30}}
        session = self.session("s.json", self.store(), [view, {"op": "picture", "file": "p.png", "size": [410, 290], "samples": 1}])
        dense, _, _ = self.run_session(session, "dense", "--storage", "dense", "--level", 0)
        busy = [subprocess.Popen([sys.executable, "-c", "while True: pass"]) for _ in range(4)]
        try:
            for n in range(3):
                bricks, _, _ = self.run_session(session, f"bricks{n}", "--storage", "bricks", "--level", 0)
                compared = self.call("compare", dense / "p.png", bricks / "p.png").stdout
                self.assertLessEqual(float(re.search(r"max (\d+)", compared).group(1)), 1, compared)
        finally:
            for process in busy:
                process.kill()
                process.wait()

    def test_a_saved_session_cuts_the_same_again(self):
        session = self.session("s.json", self.store(), CUTS, level=1)
        saved = self.folder / "saved.json"
        self.succeed("run", session, "-o", self.folder / "a", "--save", saved)
        self.succeed("export", session, "--what", "volume", "-o", self.folder / "a.zarr", "--fill", 7)
        self.succeed("export", saved, "--what", "volume", "-o", self.folder / "b.zarr", "--fill", 7)
        self.assertTrue(numpy.array_equal(self.values(self.folder / "a.zarr"), self.values(self.folder / "b.zarr")))


if __name__ == "__main__":
    unittest.main()
