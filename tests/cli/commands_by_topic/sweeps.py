# SPDX-License-Identifier: Apache-2.0
"""Solids swept by masks along paths."""
import json

from commands_by_topic.case import Case, call, nrrd_floats, write_grey_png


class Sweeps(Case):
    def test_sweep_writes_a_solid(self):
        solid = self.folder / "solid.nrrd"
        result = call("sweep", "--dims", "48,48,48", "--mask", "ellipse:12,8", "--path", "line:24,24,10:24,24,38", "-o", solid)
        self.assertEqual(result.returncode, 0, result.stderr)
        info = json.loads(call("info", solid, "--json").stdout)
        self.assertEqual(info["type"], "float32")
        self.assertAlmostEqual(info["range"][1], 1, delta=0.01)

    def sweep(self, name, *arguments, grid=("--dims", "40,40,40")):
        """Writes a volume; returns its values, x fastest, and how many voxels are said to be inside."""
        solid = self.folder / f"{name}.nrrd"
        result = call("sweep", *grid, *arguments, "-o", solid)
        self.assertEqual(result.returncode, 0, result.stderr)
        return nrrd_floats(solid), int(result.stdout.split(": ")[1].split()[0])

    def test_sweep_takes_every_mask_and_path(self):
        way = ("--path", "line:20,20,10:20,20,30")
        areas = {"circle:10": 314.2, "rectangle:16,10": 160, "square:14": 196, "star:14,8,5": 329.2,
                 "polyline:-8,-8:8,-8:8,8": 128, "ellipse:12,8": 301.6}
        for mask, area in areas.items():
            self.assertAlmostEqual(sum(self.sweep("m", "--mask", mask, *way)[0]) / 20, area, delta=0.03 * area, msg=mask)
        # A picture: this program's own, of a white half; 16 steps wide.
        picture = self.folder / "half.png"
        write_grey_png(picture, 8, 8, lambda x, y: 255 if x < 4 else 0)
        self.assertAlmostEqual(sum(self.sweep("p", "--mask", f"image:{picture},16", *way)[0]) / 20, 128, delta=6)
        recorded = self.folder / "pen.txt"
        recorded.write_text("# a pen's way\n8 20 20\n8, 20, 20\n" + "".join(f"{x} 20 20\n" for x in range(9, 33)))
        for path, length in {"polyline:8,20,20:20,20,20:20,32,20": 24, "spline:8,20,20:20,20,20:32,20,20": 24,
                             "helix:20,20,10:20,20,30:8,0.5": 32.1, f"recorded:{recorded}": 24}.items():
            for frame in "parallel", "frenet":
                total = sum(self.sweep("q", "--mask", "circle:5", "--path", path, "--frame", frame)[0])
                self.assertAlmostEqual(total / 78.5, length, delta=0.13 * length, msg=path)

    def test_sweep_options_change_what_they_say(self):
        shape = ("--mask", "ellipse:12,8", "--path", "line:14,15,12:24,22,28")
        plain, inside = self.sweep("plain", *shape)
        self.assertEqual(self.sweep("same", *shape, "--filter", "jittered,bspline,40", "--energy", "calibrated")[0], plain)
        for options in (("--filter", "none"), ("--filter", "polygon"), ("--filter", "uniform,mitchell"),
                        ("--filter", "jittered,tent,30"), ("--subdivide", "chaikin:1"), ("--pitch", "1"), ("--radius", "4"),
                        ("--footprint", "cube"), ("--footprint", "ellipsoid:1.2,0.6,1"), ("--precision", "32"),
                        ("--method", "projection")):
            values, count = self.sweep("other", *shape, *options)
            self.assertNotEqual(values, plain, options)
            self.assertAlmostEqual(count, inside, delta=0.1 * inside, msg=options)
        levels = set(self.sweep("bytes", *shape, "--precision", "8")[0])
        self.assertLessEqual(len(levels), 256)
        self.assertTrue(all(abs(v * 255 - round(v * 255)) < 1e-4 for v in levels))
        # Raw planes: thicker with the radius; crossing ones add.
        plane = ("--mask", "ellipse:10,8", "--energy", "raw", "--path", "at:20,20,20:0,0,1")
        counts = [self.sweep("raw", *plane, "--radius", r)[1] for r in (2, 3, 4)]
        self.assertTrue(0 < counts[0] < counts[1] < counts[2], counts)
        crossing = self.sweep("cross", *plane, "--path", "at:20,20,20:1,0,0")[0]
        middle = (20 * 40 + 20) * 40 + 20
        self.assertAlmostEqual(crossing[middle], 2 * self.sweep("one", *plane)[0][middle], delta=0.1)

    def test_sweeps_are_united_and_keep_their_shape_on_wide_slices(self):
        one = self.sweep("one", "--mask", "circle:6", "--path", "line:20,20,8:20,20,32")[0]
        other = self.sweep("other", "--mask", "square:8", "--path", "line:8,20,20:32,20,20")[0]
        both = self.sweep("both", "--mask", "circle:6", "--path", "line:20,20,8:20,20,32", "--mask", "square:8",
                          "--path", "line:8,20,20:32,20,20")[0]
        self.assertEqual(both, [max(a, b) for a, b in zip(one, other)])
        # 3 mm slices: as many cubic millimetres as on 1 mm ones.
        wide = self.sweep("wide", "--mask", "circle:8", "--path", "line:8,20,7:32,20,7", "--spacing", "1,1,3",
                          grid=("--dims", "40,40,14"))[0]
        self.assertAlmostEqual(3 * sum(wide), 201 * 24, delta=80)

    def test_sweep_clips_a_volume(self):
        shape = ("--mask", "circle:4", "--path", "line:12,10,-9:12,10,30")
        grid = ("--clip", self.raw, *self.layout)
        stored = self.raw.read_bytes()
        cut = self.sweep("cut", *shape, grid=grid)[0]
        probe = self.sweep("probe", *shape, "--probe", grid=grid)[0]
        self.assertEqual(len(cut), 24 * 20 * 16)
        middle, corner = (8 * 20 + 10) * 24 + 12, (8 * 20 + 5) * 24 + 6
        self.assertEqual((stored[middle], stored[corner]), (200, 200))
        self.assertAlmostEqual(cut[middle], 0, delta=2)
        self.assertEqual((cut[corner], probe[middle]), (200, 200))
        self.assertAlmostEqual(probe[corner], 0, delta=0.1)
        self.assertTrue(all(c == v or p == v for c, p, v in zip(cut, probe, stored)))
        info = json.loads(call("info", self.folder / "cut.nrrd", "--json").stdout)
        self.assertEqual(info["spacing"], [1, 1, 1.5])

    def test_sweep_refuses_what_makes_no_sense(self):
        def refused(mentions, *arguments, dims=("--dims", "8,8,8"), mask="circle:3", path="line:0,0,0:1,1,1", code=2):
            self.expect_error(code, mentions, "sweep", *dims, "--mask", mask, "--path", path, *arguments, "-o",
                              self.folder / "s.nrrd")
            self.assertFalse((self.folder / "s.nrrd").exists())

        refused(["--dims", "--clip"], dims=())
        refused(["--dims", "--clip"], "--clip", self.raw)
        refused(["--probe", "--clip"], "--probe")
        refused(["--spacing 1,0,1", "mm"], "--spacing", "1,0,1")
        for mask, mention in {"star:5,3": "star:20,8,5", "star:5,3,1": "2 to 1000", "circle:0": "above 0",
                              "polyline:0,0:5,5": "three corners", "image:leaf.png": "width", "square:a": "'a'"}.items():
            refused([mask, mention], mask=mask)
        refused(["none.png"], mask="image:none.png,20", code=1)
        for path, mention in {"curve:1,1,1:2,2,2": "spline", "spline:1,1,1": "two different", "at:1,1,1": "direction",
                              "at:1,1,1:0,0,0": "direction", "helix:1,1,1:2,2,2": "RADIUS,TURNS",
                              "helix:1,1,1:1,1,1:0,1": "no length", "helix:1,1,1:1,1,9:-2,1": "radius",
                              "line:0,0,0:1,1,1e9": "at most", "spline:0,0,0:1,1,9e4:0,0,0": "steps"}.items():
            refused([path, mention], path=path)
        refused(["none.txt"], path="recorded:none.txt", code=1)
        bad = self.folder / "bad.txt"
        bad.write_text("1 2 3\n4 5\n")
        refused([bad, "line 2"], path=f"recorded:{bad}", code=1)
        refused(["still", "--energy raw"], path="at:4,4,4:0,0,1")
        refused(["projection", "--energy raw"], "--method", "projection", "--energy", "raw")
        refused(["2 --mask", "3 --path"], "--mask", "circle:4", "--path", "line:0,0,0:1,1,1", "--path", "line:0,0,0:1,1,1")
        for option, value, mention in (("--filter", "blurred", "jittered"), ("--filter", "uniform,lanczos", "mitchell"),
                                       ("--filter", "none,box", "sub-samples"), ("--filter", "jittered,box,3", "4 to 400"),
                                       ("--subdivide", "loop:2", "chaikin"), ("--subdivide", "chaikin:20", "0 to 12"),
                                       ("--frame", "bishop", "frenet"), ("--precision", "12", "16"),
                                       ("--energy", "some", "raw"), ("--method", "magic", "projection"),
                                       ("--footprint", "ball", "ellipsoid"), ("--footprint", "cube:3", "--radius"),
                                       ("--footprint", "ellipsoid:1,2,1", "1.33"), ("--radius", "5", "2, 3 or 4"),
                                       ("--pitch", "0", "0.02")):
            refused([option, mention], option, value)
