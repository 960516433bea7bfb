# SPDX-License-Identifier: Apache-2.0
"""Volumes made, described and counted, and regions grown in them."""
import json
import struct

from commands_by_topic.case import Case, call, read_png


class Volumes(Case):
    def test_phantom_makes_labelled_volumes(self):
        head, labels, again = (self.folder / name for name in ("head.nii", "labels.nii", "again.nii"))
        result = call("phantom", "head", "-o", head, "--labels", labels, "--size", "54", "--noise", "3", "--bias", "20")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("45 x 54 x 45 voxels", result.stdout)
        self.assertIn("5 white", result.stdout)
        self.assertEqual(json.loads(call("info", labels, "--json").stdout)["range"], [0, 6])
        call("phantom", "head", "-o", again, "--size", "45x54x45", "--noise", "3", "--bias", "20")
        self.assertEqual(again.read_bytes(), head.read_bytes())
        call("phantom", "head", "-o", again, "--size", "54", "--noise", "3", "--bias", "20", "--seed", "2")
        self.assertNotEqual(again.read_bytes(), head.read_bytes())
        body = self.folder / "body.nrrd"
        self.assertEqual(call("phantom", "body", "-o", body, "--size", "40").returncode, 0)
        self.assertIn("int16", call("info", body).stdout)
        self.expect_error(2, ["size '4'"], "phantom", "head", "-o", head, "--size", "4")
        self.expect_error(2, ["--bias 5", "CT"], "phantom", "body", "-o", body, "--bias", "5")
        self.expect_error(2, ["KIND", "foot"], "phantom", "foot", "-o", body)

    def counts(self, *arguments):
        """Draws a histogram; the last column of its table."""
        picture, table = self.folder / "h.png", self.folder / "h.csv"
        result = call("histogram", *arguments, "-o", picture, "--csv", table)
        self.assertEqual(result.returncode, 0, result)
        width, height, rows = read_png(picture)
        self.assertEqual((width, height), (1200, 800))
        self.assertGreater(len(set(zip(rows[0::7], rows[1::7], rows[2::7]))), 10, "an empty picture")
        lines = table.read_text().splitlines()
        self.assertTrue(lines[0].endswith(",voxels"), lines[0])
        return [int(line.split(",")[-1]) for line in lines[1:]]

    def test_histogram_counts_every_voxel(self):
        for kind in ("intensity", "gradient"):
            self.assertEqual(sum(self.counts(self.raw, *self.layout, "--kind", kind)), 24 * 20 * 16, kind)
        counts = self.counts(self.raw, *self.layout, "--linear", "--range", "10:200")
        self.assertEqual(len(counts), 201, "a bin for each value")
        self.assertEqual(counts[200], 12 * 10 * 8)
        # What is steeper than nearly all of it is left out.
        self.assertGreater(sum(self.counts(self.raw, *self.layout, "--kind", "2d")), 0.99 * 24 * 20 * 16)

    def test_histogram_leaves_out_what_is_no_number_and_survives_one_value(self):
        floats = self.folder / "floats.raw"
        floats.write_bytes(struct.pack("<8f", 1, 2, 3, 4, 5, 6, float("nan"), float("inf")))
        self.assertEqual(sum(self.counts(floats, "--raw", "2x2x2:float32")), 6)
        stepped = self.folder / "stepped.raw"
        stepped.write_bytes(struct.pack("<8f", *(1.5 + 2.2 * i for i in (0, 1, 2, 3, 4, 5, 6, 9))))
        self.assertEqual(self.counts(stepped, "--raw", "2x2x2:float32"), [1] * 7 + [0, 0, 1], "a bin for each step")
        flat = self.folder / "flat.raw"
        flat.write_bytes(bytes([7]) * 64)
        for kind in ("intensity", "gradient", "2d"):
            self.assertEqual(sum(self.counts(flat, "--raw", "4x4x4:uint8", "--kind", kind)), 64, kind)

    def test_histogram_has_the_size_asked_for_and_refuses_what_makes_no_sense(self):
        picture = self.folder / "h.png"
        command = ("histogram", self.raw, *self.layout, "-o", picture)
        self.assertEqual(call(*command, "--size", "400x300").returncode, 0)
        self.assertEqual(read_png(picture)[:2], (400, 300))
        picture.unlink()
        self.expect_error(2, ["--kind", "3d"], *command, "--kind", "3d")
        self.expect_error(2, ["100x80", "240x180"], *command, "--size", "100x80")
        self.expect_error(2, ["--range", "gradient"], *command, "--kind", "gradient", "--range", "1:2")
        self.expect_error(2, ["t.txt", ".csv"], *command, "--csv", self.folder / "t.txt")
        self.expect_error(2, ["h.jpg", "PNG"], "histogram", self.raw, *self.layout, "-o", self.folder / "h.jpg")
        self.expect_error(1, ["nowhere"], *command, "--csv", self.folder / "nowhere" / "t.csv")
        self.assertFalse(picture.exists(), "nothing is written when something is wrong")

    def test_info_tells_geometry_and_values(self):
        result = call("info", self.raw, *self.layout, "--json")
        self.assertEqual(result.returncode, 0, result.stderr)
        info = json.loads(result.stdout)
        self.assertEqual(info["dims"], [24, 20, 16])
        self.assertEqual(info["spacing"], [1, 1, 1.5])
        self.assertEqual(info["range"], [0, 200])
        self.assertEqual(sum(info["histogram"]["counts"]), 24 * 20 * 16)

    def test_grow_fills_the_box_and_counts_generations(self):
        labels = self.folder / "labels.nrrd"
        result = call("grow", self.raw, *self.layout, "--seed", "6,5,4", "--range", "100:255", "-o", labels)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("960", result.stdout)  # 12 x 10 x 8 voxels
        info = json.loads(call("info", labels, "--json").stdout)
        self.assertEqual(info["spacing"], [1, 1, 1.5], "the input's geometry")
        self.assertEqual(info["range"], [0, 1])
        link = self.folder / "link.nrrd"
        link.symlink_to("labels.nrrd")
        seeds = call("grow", self.raw, *self.layout, "--seed", "6,5,4", "--range", "100:255", "--steps", "0", "-o", link)
        self.assertEqual(seeds.returncode, 0)
        self.assertTrue(link.is_symlink(), "a link stays, its target is replaced")
        self.assertEqual(sum(json.loads(call("info", labels, "--json").stdout)["histogram"]["counts"][128:]), 1)

    def test_reduce_makes_means_where_they_were(self):
        small = self.folder / "small.nrrd"
        result = call("reduce", self.raw, *self.layout, "--by", "2x3x4", "-o", small)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("12 x 7 x 4 voxels of 2 x 3 x 6 mm", result.stdout)  # the last row is of two voxels only
        info = json.loads(call("info", small, "--json").stdout)
        self.assertEqual(info["dims"], [12, 7, 4])
        self.assertEqual(info["range"], [1, 200])  # the mean of 0 and 1, rounded; the inside of the box
        middle = [0.5 * 1, 1, 1.5 * 1.5]
        self.assertEqual([row[3] for row in info["worldFromVoxel"][:3]], middle, "the first block's middle")

    def test_reduce_keeps_labels_whole(self):
        labels, small = self.folder / "labels.nrrd", self.folder / "small.nrrd"
        call("phantom", "head", "-o", self.folder / "head.nii", "--labels", labels, "--size", "54")
        result = call("reduce", labels, "--labels", "--by", "3", "-o", small)
        self.assertEqual(result.returncode, 0, result.stderr)
        counts = json.loads(call("info", small, "--json").stdout)["histogram"]["counts"]
        self.assertEqual(sum(1 for n in counts if n), 7, "nothing between two labels")

    def test_reduce_refuses_what_makes_no_sense(self):
        small = self.folder / "small.nrrd"
        for by in ("0", "65", "1.5", "2x2", "two"):
            self.expect_error(2, ["--by"], "reduce", self.raw, *self.layout, "--by", by, "-o", small)
        self.expect_error(2, ["small.txt", ".nrrd"], "reduce", self.raw, *self.layout, "-o", self.folder / "small.txt")
        self.expect_error(1, ["gone.nii"], "reduce", self.folder / "gone.nii", "-o", small)
        self.assertFalse(small.exists())

    def test_what_no_device_has_room_for_can_be_reduced(self):
        """A device has 2048 texels or more a side; this row is longer than any has."""
        long, small = self.folder / "long.raw", self.folder / "small.nrrd"
        long.write_bytes(bytes(i * 7 % 200 for i in range(40000)) * 4)
        layout = ("--raw", "40000x2x2:uint8")
        self.expect_error(1, ["vstudio reduce"], "render", long, *layout, "-o", self.folder / "p.png")
        self.assertEqual(call("reduce", long, *layout, "--by", "64x1x1", "-o", small).returncode, 0)
        self.assertEqual(call("render", small, "-o", self.folder / "p.png", "--size", "60x40").returncode, 0)
