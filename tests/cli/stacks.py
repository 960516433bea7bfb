#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Stacks of TIFF pictures as other programs write them, and stores that are made of them slice by slice.

usage: stacks.py VSTUDIO
"""
import resource
import subprocess
import unittest

from scan_case import ScanCase, libraries, noise

numpy, tifffile, zarr = libraries("numpy", "tifffile", "zarr")


class Stacks(ScanCase):
    def values_of(self, stack, *options):
        """What vstudio reads of a stack, by way of a store; and the spacing that it takes, in mm."""
        out = self.folder / "read.zarr"
        subprocess.run(["rm", "-rf", out], check=True)
        self.succeed("convert", stack, out, "--chunk", 16, *options)
        group = zarr.open_group(str(out), "r")
        scale = group.attrs["multiscales"][0]["datasets"][0]["coordinateTransformations"][0]["scale"]
        return group["0"][:], scale

    def test_every_kind_of_value_and_layout(self):
        layouts = [{}, {"compression": "zlib"}, {"tile": (16, 32)}, {"tile": (32, 16), "compression": "zlib"},
                   {"bigtiff": True}, {"byteorder": ">"}, {"rowsperstrip": 7}, {"predictor": True, "compression": "zlib"}]
        kinds = ["u1", "i1", "u2", "i2", "u4", "i4", "f4"]
        for number, layout in enumerate(layouts):
            for kind in kinds:
                if "predictor" in layout and kind == "f4":
                    continue
                with self.subTest(layout=layout, kind=kind):
                    values = noise((19, 33, 47), kind, number)
                    path = self.folder / "a.tif"
                    tifffile.imwrite(path, values, photometric="minisblack", metadata=None, **layout)
                    read, scale = self.values_of(path)
                    self.assertTrue((read == values).all())
                    self.assertEqual(scale, [1, 1, 1])
        values = noise((5, 6, 7), "f8")
        tifffile.imwrite(self.folder / "a.tif", values, metadata=None)
        self.assertTrue((self.values_of(self.folder / "a.tif")[0] == values.astype("f4")).all())

    def test_a_folder_of_files_in_the_order_of_their_numbers(self):
        values = noise((25, 20, 30), "u2")
        stack = self.folder / "stack"
        stack.mkdir()
        for z in range(25):
            tifffile.imwrite(stack / f"slice{z + 1}.tif", values[z], metadata=None)
        (stack / "scanner.log").write_text("1 mm")
        read, _ = self.values_of(stack)
        self.assertTrue((read == values).all())
        done = self.succeed("info", stack)
        self.assertIn("30 x 20 x 25 voxels, uint16", done.stdout)
        tifffile.imwrite(stack / "slice7.tif", values[6, :10], metadata=None)
        self.refuse(r"slice7.tif: a picture of 30 x 10 is among those of 30 x 20", "info", stack)

    def test_what_microscopes_say(self):
        values = noise((2, 7, 3, 20, 30), "u2")
        path = self.folder / "ij.tif"
        tifffile.imwrite(path, values, imagej=True, resolution=(4, 4), metadata={"spacing": 1.5, "unit": "um", "axes": "TZCYX"})
        self.refuse("3 channels; choose one of 0 to 2 with --channel", "info", path)
        self.refuse("no channel 3", "info", path, "--channel", 3)
        self.refuse("--frame", "info", path, "--channel", 0)
        read, scale = self.values_of(path, "--channel", 2, "--frame", 1)
        self.assertTrue((read == values[1, :, 2]).all())
        numpy.testing.assert_allclose(scale, [0.0015, 0.00025, 0.00025])
        path = self.folder / "a.ome.tif"
        for axes, order in (("TZCYX", (0, 1, 2)), ("CTZYX", (2, 0, 1))):
            written = values if axes == "TZCYX" else values.transpose(2, 0, 1, 3, 4)
            tifffile.imwrite(path, written, metadata={"axes": axes, "PhysicalSizeX": 0.5, "PhysicalSizeY": 250, "PhysicalSizeZ": 2.0,
                                                      "PhysicalSizeXUnit": "\u00b5m", "PhysicalSizeYUnit": "nm"})
            read, scale = self.values_of(path, "--channel", 1, "--frame", 0)
            self.assertTrue((read == values[0, :, 1]).all(), axes)
            numpy.testing.assert_allclose(scale, [0.002, 0.00025, 0.0005])

    def test_pixels_in_a_centimetre(self):
        """Of inches nobody knows whether they are the specimen's or a printer's."""
        values = noise((5, 20, 30), "u2")
        path = self.folder / "a.tif"
        tifffile.imwrite(path, values, metadata=None, resolution=(200, 250), resolutionunit="CENTIMETER")
        done = self.succeed("info", path)
        self.assertIn("how far apart its slices are is not said; 0.05 mm is taken", done.stderr)
        _, scale = self.values_of(path)
        numpy.testing.assert_allclose(scale, [0.05, 0.04, 0.05])
        tifffile.imwrite(path, values, metadata=None, resolution=(300, 300), resolutionunit="INCH")
        self.assertIn("1 x 1 x 1 mm is taken", self.succeed("info", path).stderr)

    def test_spacing_that_a_person_gives(self):
        values = noise((5, 20, 30), "u2")
        path = self.folder / "a.tif"
        tifffile.imwrite(path, values, metadata=None)
        read, scale = self.values_of(path, "--spacing", "0.5,0.25,2")
        self.assertTrue((read == values).all())
        numpy.testing.assert_allclose(scale, [2, 0.25, 0.5])
        for bad, why in (("0.5,0.5", "0.5,0.5,1.25"), ("1,0,1", "0 mm is not the size of a voxel"), ("1,1,nan", "nan")):
            self.refuse(why, "convert", path, self.folder / "bad.zarr", "--spacing", bad, status=2)
            self.assertFalse((self.folder / "bad.zarr").exists())

    def test_a_stack_of_which_imagej_describes_only_the_first_picture(self):
        """As it writes those of 4 GB and more."""
        values = noise((30, 20, 24), ">u2")
        path = self.folder / "large.tif"
        tifffile.imwrite(path, values[0], byteorder=">", metadata=None, contiguous=True,
                         description="ImageJ=1.53\nimages=30\nslices=30\nunit=micron\nspacing=2.0\n")
        offset = tifffile.TiffFile(path).pages[0].dataoffsets[0]
        start = path.read_bytes()[:offset]
        data = values.tobytes()
        # Behind the values may stand nothing: what libtiff needs lies before them.
        if len(path.read_bytes()) > offset + values[0].nbytes:
            self.skipTest("the directory lies behind the first picture")
        path.write_bytes(start + data)
        read, _ = self.values_of(path)
        self.assertTrue((read == values).all())
        path.write_bytes(start + data[:-10])
        self.refuse("ImageJ wrote 30 pictures, and fewer are there", "info", path)

    def test_white_may_be_zero(self):
        for kind in ("u1", "u2"):
            values = noise((5, 20, 30), kind)
            path = self.folder / "a.tif"
            tifffile.imwrite(path, values, photometric="miniswhite", metadata=None)
            read, _ = self.values_of(path)
            self.assertTrue((read == numpy.iinfo(kind).max - values).all())

    def test_what_is_no_stack(self):
        """Pictures beside DICOM files, and files of several pages side by side."""
        mixed = self.folder / "mixed"
        (mixed / "DICOM").mkdir(parents=True)
        tifffile.imwrite(mixed / "preview.tif", noise((20, 30), "u1"), metadata=None)
        self.refuse("mixed: ", "info", mixed)
        several = self.folder / "several"
        several.mkdir()
        for n in range(3):
            tifffile.imwrite(several / f"{n}.tif", noise((4, 20, 30), "u1"), photometric="minisblack", metadata=None)
        self.refuse(r"\.tif: it has several pages, and is one of several files; open one", "info", several)
        self.refuse("it is a stack of pictures; leave out --level", "info", several, "--level", 1)

    def test_bad_stacks(self):
        path = self.folder / "a.tif"
        tifffile.imwrite(path, noise((4, 20, 30, 3), "u1"), photometric="rgb", metadata=None)
        self.refuse("its pixels are colours; save it with one value a pixel", "info", path)
        tifffile.imwrite(path, noise((40, 50, 60), "u2"), metadata=None)
        whole = path.read_bytes()
        for cut in (3, 7, 100, 5000, len(whole) // 2):
            path.write_bytes(whole[:cut])
            self.refuse("a.tif: ", "info", path)
        tifffile.imwrite(path, noise((4, 20, 30), "f4").astype("c8"), photometric="minisblack", metadata=None)
        self.refuse("neither whole numbers nor floats", "info", path)
        tifffile.imwrite(path, noise((4, 20, 30), "u1"), photometric="minisblack", metadata=None, extratags=[(274, 3, 1, 4, True)])
        self.refuse("rows do not begin at the top left", "info", path)
        tifffile.imwrite(path, noise((4, 20, 30), "u1"), photometric="minisblack", metadata=None, description="ImageJ=1.53\nimages=9\nslices=9\n")
        self.refuse("ImageJ wrote 9 pictures, and 4 are there", "info", path)
        path.write_bytes(b"II*\0" + b"\xff" * 200)
        self.refuse("a.tif: ", "info", path)
        self.refuse("it is one file; leave out --level", "info", path, "--level", 1)

    def test_memory_is_for_a_slab_and_not_for_the_stack(self):
        path, store = self.folder / "large.tif", self.folder / "large.zarr"
        random = numpy.random.default_rng(1)
        with tifffile.TiffWriter(path, bigtiff=True) as writer:
            for _ in range(400):
                writer.write(random.integers(0, 200, (700, 900)).astype("u1"), contiguous=False, metadata=None)
        self.refuse(r"64 slices at once take some 115 MiB, and 50 are allowed; give --memory more, or --chunk less",
                    "convert", path, store, "--memory", 50, status=2)
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss
        self.succeed("convert", path, store, "--memory", 150)
        most = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss
        self.assertLess(most, max(before, 200 * 1024), "kilobytes of the largest process; the stack has 246,000")
        values = tifffile.imread(path)
        self.assertTrue((zarr.open_group(str(store), "r")["0"][:] == values).all())

    def test_another_stack_of_that_name_is_not_gone_on_with(self):
        stack, store = self.folder / "stack", self.folder / "a.zarr"
        stack.mkdir()
        for z in range(24):
            tifffile.imwrite(stack / f"{z}.tif", numpy.full((80, 90), 5, "u1"), metadata=None)
        self.succeed("convert", stack, store, "--chunk", 8)
        marker = store / ".volume-studio-unfinished"
        # As if it had been killed behind the first slab.
        again = self.folder / "again.zarr"
        running = subprocess.Popen([self.vstudio, "convert", stack, again, "--chunk", "8"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        unfinished = again / marker.name
        first = ""
        while running.poll() is None and not first:
            first = unfinished.read_text().split("\n")[0] if unfinished.exists() else ""
        running.wait()
        if not first:
            self.skipTest("it was done before anyone looked")
        marker.write_text(f"{first}\n0 0 ;\n")
        for z in range(24):
            tifffile.imwrite(stack / f"{z}.tif", numpy.zeros((80, 90), "u1"), metadata=None)
        self.refuse("with other settings, was begun there", "convert", stack, store, "--chunk", 8)

    def test_a_raw_file_is_gone_through_too(self):
        values = noise((70, 40, 50), "<i2")
        path = self.folder / "a.raw"
        path.write_bytes(b"head" + values.tobytes())
        read, scale = self.values_of(path, "--raw", "50x40x70:int16:0.5,0.6,0.7:4")
        self.assertTrue((read == values).all())
        numpy.testing.assert_allclose(scale, [0.7, 0.6, 0.5])


if __name__ == "__main__":
    unittest.main(verbosity=1)
