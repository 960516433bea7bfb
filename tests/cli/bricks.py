#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Pictures from bricks: of a volume that would fit they are those of one texture; of a store whose finest level does not, they have
what that level has; what cannot be read is said in one line.

usage: bricks.py VSTUDIO
"""
import json
import pathlib
import re
import unittest

from scan_case import ScanCase, libraries

numpy, zarr = libraries("numpy", "zarr")

SMALL = ("--size", "300x220", "--samples", "2")


class Bricks(ScanCase):
    def phantom(self, name, kind="vessels", size="224x256x192", *options):
        path = self.folder / name
        self.succeed("phantom", kind, "--size", size, "-o", path, *options)
        return path

    def picture(self, name, scan, *options):
        path = self.folder / name
        done = self.succeed("render", scan, "-o", path, *SMALL, *options)
        return path, done.stderr

    def apart(self, a, b):
        """Greatest and mean difference of two pictures, of 255."""
        out = self.call("compare", a, b).stdout
        most, mean = re.search(r"max (\d+) mean ([\d.]+)", out).groups()
        return int(most), float(mean)

    def test_ranges_are_those_of_the_values(self):
        for size, chunk in (("61x47x33", 64), ("61x47x33", 16), ("70", 64)):
            with self.subTest(size=size, chunk=chunk):
                scan = self.phantom("a.nrrd", "body", size, "--noise", "3")
                self.succeed("convert", scan, self.folder / f"{size}{chunk}.zarr", "--chunk", chunk)
                group = zarr.open_group(str(self.folder / f"{size}{chunk}.zarr"), "r")
                side = group.attrs["volumeStudio"]["ranges"]["side"]
                values, ranges = group["0"][:], group["ranges"][:]
                for cell in numpy.ndindex(ranges.shape[:3]):
                    z, y, x = (slice(side * n, side * n + side) for n in cell)
                    self.assertEqual(tuple(ranges[cell]), (values[z, y, x].min(), values[z, y, x].max()))

    def test_a_phantom_is_the_same_box_by_box(self):
        for kind in ("head", "body", "vessels"):
            with self.subTest(kind=kind):
                noise = ("--noise", "4", "--seed", "7") + (("--bias", "20") if kind == "head" else ())
                whole = self.phantom("a.nrrd", kind, "90", *noise, "--labels", self.folder / "labels.nrrd")
                boxes = self.phantom(f"{kind}.zarr", kind, "90", *noise, "--labels", self.folder / f"{kind}-labels.zarr")
                for one, other in ((whole, boxes), (self.folder / "labels.nrrd", self.folder / f"{kind}-labels.zarr")):
                    size, = {re.search(r"\d+ x \d+ x \d+", self.succeed("info", p).stdout).group() for p in (one, other)}
                    self.assertTrue(size)
                    read = self.folder / "b.nrrd"
                    self.succeed("reduce", other, "--by", "1", "-o", read)
                    bodies = [p.read_bytes().split(b"\n\n", 1) for p in (one, read)]
                    values = [numpy.frombuffer(__import__("zlib").decompress(body, 31) if b"gzip" in head else body, "u1") for head, body in bodies]
                    self.assertTrue(numpy.array_equal(*values))

    def test_what_fits_looks_the_same_in_bricks(self):
        scan = self.phantom("a.nrrd")
        store = self.folder / "a.zarr"
        self.succeed("convert", scan, store)
        quarter = 224 * 256 * 192 // 4
        for n, options in enumerate((("--mode", "surface", "--range", "130:236"), ("--mode", "mip"), ("--mode", "xray"),
                                     ("--mode", "volume"), ("--mode", "surface", "--shadows", "--zoom", "3"))):
            with self.subTest(options=options):
                dense, _ = self.picture("dense.png", scan, *options)
                for source in ((scan,), (store, "--level", 0)):
                    # Half of the memory is for bricks.
                    bricks, said = self.picture("bricks.png", *source, *options, "--storage", "bricks", "--device-memory",
                                                f"{2 * quarter / 2 ** 20:.2f}MiB")
                    most, mean = self.apart(dense, bricks)
                    self.assertLessEqual(most, 1, said)
                    self.assertLess(mean, 0.02)

    def test_what_is_worked_on_is_coarser_than_what_is_seen(self):
        store = self.phantom("a.zarr", "vessels", "224x256x192")
        options = ("--range", "130:236", "--zoom", "1.5")
        finest, _ = self.picture("0.png", store, *options, "--level", 0)
        sharp, _ = self.picture("2.png", store, *options, "--level", 2)
        coarse, _ = self.picture("c.png", store, *options, "--level", 2, "--storage", "dense")
        self.assertLess(self.apart(finest, sharp)[1], 0.1)
        self.assertGreater(self.apart(finest, coarse)[1], 1)
        # Where there is no room to work on the finest, a coarser one is chosen, and said.
        small, said = self.picture("s.png", store, *options, "--device-memory", "40MiB")
        self.assertRegex(said, r"this is level [12] of 0 \(")
        self.assertLess(self.apart(finest, small)[1], 0.1)

    def test_a_session_says_what_it_ran_on(self):
        store = self.phantom("a.zarr", "vessels", "160x192x128")
        session = self.folder / "s.json"
        session.write_text(json.dumps({"volumeStudioSession": 1, "volume": {"path": str(store), "level": 1}, "operations": [
            {"op": "picture", "file": "p.png", "size": [300, 220]}]}))
        pictures = {}
        for storage, said in (("auto", "bricks"), ("dense", "dense")):
            out = self.folder / storage
            self.succeed("run", session, "-o", out, "--storage", storage)
            report = json.loads((out / "report.json").read_text())
            self.assertEqual((report["storage"], report["level"]), (said, 1))
            self.assertGreater(report["memory"]["devicePeakBytes"], 100_000)
            self.assertGreater(report["memory"]["hostPeakBytes"], report["memory"]["devicePeakBytes"] // 100)
            pictures[storage] = out / "p.png"
        self.assertGreater(self.apart(*pictures.values())[1], 0.1)

    def test_a_damaged_chunk_is_said_and_the_rest_is_there(self):
        store = self.phantom("a.zarr", "vessels", "224x256x192")
        whole, _ = self.picture("whole.png", store, "--level", 2, "--mode", "mip")
        chunk = store / "0" / "1" / "1" / "1"
        chunk.write_bytes(chunk.read_bytes()[:40])
        damaged, said = self.picture("damaged.png", store, "--level", 2, "--mode", "mip")
        self.assertRegex(said, r"note: .*a\.zarr/0/1/1/1: .*; pictures are coarser there")
        self.assertLess(self.apart(whole, damaged)[1], 5)
        (store / "ranges" / ".zarray").unlink()
        self.refuse("ranges", "render", store, "-o", self.folder / "x.png", "--level", 2)

    def test_stores_without_ranges_are_seen_all_the_same(self):
        store = self.phantom("a.zarr", "vessels", "160x192x128")
        whole, _ = self.picture("whole.png", store, "--level", 1)
        attributes = json.loads((store / ".zattrs").read_text())
        del attributes["volumeStudio"]["ranges"]
        (store / ".zattrs").write_text(json.dumps(attributes))
        other, said = self.picture("other.png", store, "--level", 1)
        self.assertIn("vstudio convert makes a store that says it", said)
        self.assertLess(self.apart(whole, other)[1], 0.02)

    def test_amounts_of_memory(self):
        scan = self.phantom("a.nrrd", "head", "20")
        for amount in ("lots", "0", "-3MiB", "5TB", "1e99"):
            self.refuse("--device-memory .*512MiB or 4GiB", "render", scan, "-o", self.folder / "x.png", f"--device-memory={amount}",
                        status=2)
        self.picture("x.png", scan, "--device-memory", "1GiB", "--memory", "300")


if __name__ == "__main__":
    unittest.main(verbosity=1)
