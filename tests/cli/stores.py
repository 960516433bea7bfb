#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Stores of OME-Zarr: what vstudio writes, the Zarr library reads, and the other way round; bad ones are refused in one line.

usage: stores.py VSTUDIO
"""
import json
import os
import re
import shutil
import signal
import subprocess
import time
import unittest

from scan_case import ScanCase, libraries, noise

numcodecs, numpy, zarr = libraries("numcodecs", "numpy", "zarr")


def read_nrrd(path):
    """Values (z, y, x) and the header of a file that vstudio wrote."""
    header, data = path.read_bytes().split(b"\n\n", 1)
    fields = dict(line.split(": ", 1) for line in header.decode().split("\n") if ": " in line)
    data = numcodecs.GZip().decode(data) if fields["encoding"] == "gzip" else data
    kinds = {"uint8": "u1", "int8": "i1", "uint16": "<u2", "int16": "<i2", "uint32": "<u4", "int32": "<i4", "float": "<f4",
             "unsigned char": "u1", "signed char": "i1", "unsigned short": "<u2", "short": "<i2", "unsigned int": "<u4", "int": "<i4"}
    sizes = [int(n) for n in fields["sizes"].split()]
    return numpy.frombuffer(data, kinds[fields["type"]]).reshape(sizes[::-1]), fields


def image(scales, axes="zyx", unit="micrometer", translations=None):
    """The attributes of an image whose levels have these scales."""
    types = {"t": "time", "c": "channel"}
    described = [{"name": a, "type": types.get(a, "space"), **({} if a in types else {"unit": unit})} for a in axes]
    datasets = []
    for level, scale in enumerate(scales):
        transforms = [{"type": "scale", "scale": list(scale)}]
        if translations:
            transforms.append({"type": "translation", "translation": list(translations[level])})
        datasets.append({"path": str(level), "coordinateTransformations": transforms})
    return {"multiscales": [{"version": "0.4", "axes": described, "datasets": datasets}]}


class Stores(ScanCase):
    def make(self, name, values, attributes, chunks=None, **how):
        """A store with levels, each every second value of the one before."""
        path = self.folder / name
        group = zarr.open_group(zarr.NestedDirectoryStore(str(path)) if how.get("dimension_separator", "/") == "/"
                                else zarr.DirectoryStore(str(path)), "w")
        for level in range(len(attributes["multiscales"][0]["datasets"])):
            one = values[tuple(slice(None, None, 2 ** level if a >= values.ndim - 3 else 1) for a in range(values.ndim))]
            group.create_dataset(str(level), data=one, chunks=chunks or one.shape, **how)
        group.attrs.update(attributes)
        return path

    def values_of(self, store, *options):
        """What vstudio reads of a store."""
        out = self.folder / "read.nrrd"
        self.succeed("reduce", store, "--by", "1", "-o", out, *options)
        return read_nrrd(out)

    def test_what_others_write_is_read(self):
        codecs = {"lz4": numcodecs.Blosc("lz4"), "zstd in blosc": numcodecs.Blosc("zstd", shuffle=2), "zlib in blosc":
                  numcodecs.Blosc("zlib"), "zstd": numcodecs.Zstd(3), "zlib": numcodecs.Zlib(6), "gzip": numcodecs.GZip(1), "raw": None}
        kinds = ["u1", "i1", "<u2", ">u2", "<i2", "<u4", ">i4", "<f4", ">f4"]
        shapes = [(20, 30, 40), (7, 5, 33), (65, 64, 3)]
        chunkings = [(8, 16, 32), (64, 64, 64), (1, 30, 40), (3, 5, 7)]
        n = 0
        for codec_name, codec in codecs.items():
            for kind in kinds:
                shape, chunks = shapes[n % len(shapes)], chunkings[n % len(chunkings)]
                n += 1
                with self.subTest(codec=codec_name, kind=kind, shape=shape, chunks=chunks):
                    values = noise(shape, kind, n)
                    path = self.make(f"{n}.zarr", values, image([(2, 1, 0.5)]), chunks, compressor=codec,
                                     dimension_separator="./"[n % 2])
                    read, fields = self.values_of(path)
                    self.assertTrue((read == values).all())
                    self.assertIn("(0.0005", fields["space directions"])

    def test_values_of_64_bits_become_floats(self):
        for kind in ("<i8", "<u8", "<f8"):
            values = noise((9, 8, 7), kind)
            read, fields = self.values_of(self.make(f"{kind[1:]}.zarr", values, image([(1, 1, 1)])))
            self.assertEqual(fields["type"], "float")
            self.assertTrue((read == values.astype("f4")).all())

    def test_chunks_without_a_file_hold_the_fill_value(self):
        path = self.folder / "empty.zarr"
        group = zarr.open_group(str(path), "w")
        array = group.create_dataset("0", shape=(20, 20, 20), chunks=(8, 8, 8), dtype="<i2", fill_value=-1000, dimension_separator="/")
        array[8:16, 8:16, 0:8] = 7
        group.attrs.update(image([(1, 1, 1)]))
        read, _ = self.values_of(path)
        self.assertTrue((read == array[:]).all())
        self.assertEqual(int(read[0, 0, 0]), -1000)

    def test_channels_and_times_are_chosen(self):
        values = noise((2, 3, 6, 7, 8), "<u2")
        attributes = image([(1, 1, 1, 1, 1)], "tczyx", "millimeter")
        attributes["omero"] = {"channels": [{"label": "DAPI"}, {"label": "GFP"}, {"label": "RFP"}]}
        path = self.make("many.zarr", values, attributes, (1, 2, 4, 4, 4))
        self.refuse("3 channels; choose one of 0 to 2 with --channel: 0 DAPI, 1 GFP, 2 RFP", "info", path)
        self.refuse("--frame", "info", path, "--channel", 1)
        self.refuse("no channel 3", "info", path, "--channel", 3, "--frame", 0)
        read, _ = self.values_of(path, "--channel", 1, "--frame", 1)
        self.assertTrue((read == values[1, 1]).all())

    def test_axes_in_another_order(self):
        values = noise((6, 7, 8), "u1")
        read, _ = self.values_of(self.make("xyz.zarr", values, image([(1, 1, 1)], "xyz"), (4, 4, 4)))
        self.assertTrue((read == values.transpose()).all())
        flat = noise((6, 7), "u1")
        read, _ = self.values_of(self.make("yx.zarr", flat, image([(1, 1)], "yx"), (4, 4)))
        self.assertTrue((read[0] == flat).all())

    def test_levels(self):
        values = noise((20, 24, 28), "<i2")
        scales = [(3, 2, 1), (6, 4, 2)]
        path = self.make("levels.zarr", values, image(scales, unit="millimeter", translations=[(0, 0, 0), (1.5, 1, 0.5)]), (8, 8, 8))
        finest, fields = self.values_of(path)
        self.assertTrue((finest == values).all())
        read, fields = self.values_of(path, "--level", 1)
        self.assertTrue((read == values[::2, ::2, ::2]).all())
        self.assertEqual([float(n) for n in re.findall(r"-?[\d.]+", fields["space origin"])], [0.5, 1, 1.5])
        self.refuse(r"no level 2; choose one of 0 \(28 x 24 x 20\), 1 \(14 x 12 x 10\)", "info", path, "--level", 2)

    def test_what_we_write_is_read_by_others(self):
        for kind in ("vessels", "head", "body"):
            scan, store = self.folder / f"{kind}.nrrd", self.folder / f"{kind}.zarr"
            self.succeed("phantom", kind, "-o", scan, "--size", "90x70x50")
            self.succeed("convert", scan, store, "--chunk", 32)
            values, fields = read_nrrd(scan)
            group = zarr.open_group(str(store), "r")
            self.assertTrue((group["0"][:] == values).all())
            self.assertEqual(group["0"].chunks, (32, 32, 32))
            image_of = group.attrs["multiscales"][0]
            spacing = [numpy.linalg.norm([float(n) for n in vector.split(",")])
                       for vector in re.findall(r"\(([^)]*)\)", fields["space directions"])]
            for level, dataset in enumerate(image_of["datasets"]):
                scale, shift = (t[t["type"]] for t in dataset["coordinateTransformations"])
                numpy.testing.assert_allclose(scale, [s * 2 ** level for s in spacing[::-1]])
                numpy.testing.assert_allclose(shift, [s * (2 ** level - 1) / 2 for s in spacing[::-1]])
                shape = tuple(-(-n // 2 ** level) for n in values.shape)
                self.assertEqual(group[dataset["path"]].shape, shape)
                small, _ = self.values_of(store, "--level", level)
                self.assertTrue((group[str(level)][:] == small).all())
                if level > 0:
                    reduced = self.folder / "reduced.nrrd"
                    self.succeed("reduce", store, "--level", level - 1, "-o", reduced)
                    self.assertTrue((read_nrrd(reduced)[0] == small).all(), "each level is the mean of the one before")
            self.assertEqual([a["unit"] for a in image_of["axes"]], ["millimeter"] * 3)
            back, again = self.values_of(store)
            self.assertTrue((back == values).all())
            for key in ("space directions", "space origin"):
                self.assertEqual(again[key], fields[key])

    def test_an_interrupted_store_is_gone_on_with(self):
        scan, store, whole = self.folder / "a.nrrd", self.folder / "a.zarr", self.folder / "whole.zarr"
        self.succeed("phantom", "head", "--size", "160", "-o", scan)
        self.succeed("convert", scan, whole, "--chunk", 16)
        running = subprocess.Popen([self.vstudio, "convert", scan, store, "--chunk", "16"], stdout=subprocess.DEVNULL,
                                   stderr=subprocess.DEVNULL)
        unfinished = store / ".volume-studio-unfinished"
        while running.poll() is None and not (unfinished.exists() and ";" in unfinished.read_text()):
            time.sleep(0.001)
        running.send_signal(signal.SIGKILL)
        running.wait()
        if unfinished.exists():
            self.refuse("is not finished; write it again", "info", store)
            self.refuse("with other settings, was begun there", "convert", scan, store, "--chunk", 32)
            first = (store / "0/0/5/5").stat().st_mtime_ns
            self.succeed("convert", scan, store, "--chunk", 16)
            self.assertEqual((store / "0/0/5/5").stat().st_mtime_ns, first, "what is done is not done again")
        a, b = zarr.open_group(str(store), "r"), zarr.open_group(str(whole), "r")
        for level in b:
            self.assertTrue((a[level][:] == b[level][:]).all())
        self.refuse("there is a store that is finished already", "convert", scan, store)
        self.refuse("ends in .zarr", "convert", scan, self.folder / "a.tif")

    def test_ctrl_c_says_how_to_go_on(self):
        """On a terminal it also shows how far it is, and about how long the rest takes."""
        store = self.folder / "a.zarr"
        master, terminal = os.openpty()
        running = subprocess.Popen([self.vstudio, "phantom", "head", "--size", "640", "-o", store], stdout=subprocess.DEVNULL, stderr=terminal)
        os.close(terminal)
        shown = b""
        isInterrupted = False
        try:
            while chunk := os.read(master, 4096):
                shown += chunk
                if b" left" in shown and not isInterrupted:
                    running.send_signal(signal.SIGINT)
                    isInterrupted = True
        except OSError:  # as Linux ends what a terminal shows
            pass
        os.close(master)
        self.assertEqual(running.wait(), 1)
        self.assertRegex(shown.decode(), r"writing .*a\.zarr \d+ %, about \d+ (s|min|h) left")
        self.assertIn("a.zarr: stopped before it was finished; the same command goes on with it", shown.decode())
        self.assertTrue((store / ".volume-studio-unfinished").exists())

    def test_bad_stores(self):
        values = noise((20, 24, 28), "<i2")
        good = self.make("good.zarr", values, image([(1, 1, 1), (2, 2, 2)]), (8, 8, 8))

        def spoilt(change):
            path = self.folder / "bad.zarr"
            shutil.rmtree(path, ignore_errors=True)
            shutil.copytree(good, path)
            change(path)
            return path

        def edit(name, **members):
            def change(path):
                json_of = json.loads((path / name).read_text())
                json_of.update(members)
                (path / name).write_text(json.dumps(json_of))
            return change

        def dataset(**members):
            def change(path):
                attributes = json.loads((path / ".zattrs").read_text())
                attributes["multiscales"][0]["datasets"][0].update(members)
                (path / ".zattrs").write_text(json.dumps(attributes))
            return change

        cases = [
            ("cut short", r"0/1/1/1: this chunk cannot be read: it is cut short or damaged \(blosc\)",
             lambda p: (p / "0/1/1/1").write_bytes((p / "0/1/1/1").read_bytes()[:50])),
            ("empty", "0/1/1/1: this chunk cannot be read", lambda p: (p / "0/1/1/1").write_bytes(b"")),
            ("of another size", r"0/1/1/1: .*it holds \d+ bytes of the 1024",
             lambda p: (p / "0/1/1/1").write_bytes(numcodecs.Blosc("lz4").encode(bytes(77)))),
            ("shape against chunks", r"\.zarray: chunks: must be 3 numbers", edit("0/.zarray", chunks=[8, 8])),
            ("hostile shape", "1.56e.16 chunks", edit("0/.zarray", shape=[2000000, 2000000, 2000000])),
            ("hostile chunks", "1 GiB", edit("0/.zarray", chunks=[100000, 100000, 100000])),
            ("no number", "shape", edit("0/.zarray", shape=[20, 24, "x"])),
            ("zero", "shape", edit("0/.zarray", shape=[20, 24, 0])),
            ("too many axes", "numbers", edit("0/.zarray", shape=[1] * 40, chunks=[1] * 40)),
            ("unknown codec", "'lzma' compressed cannot be read", edit("0/.zarray", compressor={"id": "lzma"})),
            ("unknown type", "dtype", edit("0/.zarray", dtype="<c16")),
            ("fortran", "order", edit("0/.zarray", order="F")),
            ("filters", "filters", edit("0/.zarray", filters=[{"id": "delta"}])),
            ("zarr 3", "zarr_format: only version 2", edit("0/.zarray", zarr_format=3)),
            ("no JSON", "not valid JSON", lambda p: (p / "0/.zarray").write_text("{")),
            ("no array", r"0/\.zarray", lambda p: (p / "0/.zarray").unlink()),
            ("no image", "without an image of OME-Zarr", lambda p: (p / ".zattrs").unlink()),
            ("no multiscales", "multiscales", lambda p: (p / ".zattrs").write_text("{}")),
            ("out of the store", "folder in the store", dataset(path="../good.zarr/0")),
            ("absolute", "folder in the store", dataset(path="/etc")),
            ("no scale", "must be 3 numbers", dataset(coordinateTransformations=[{"type": "scale", "scale": [1]}])),
            ("spacing of zero", "spacing", dataset(coordinateTransformations=[{"type": "scale", "scale": [0, 1, 1]}])),
            ("no regular file", "0/1/1/1: this is no chunk of 1024 bytes",
             lambda p: ((p / "0/1/1/1").unlink(), os.mkfifo(p / "0/1/1/1"))),
            ("too large a file", "0/1/1/1: this is no chunk of 1024 bytes", lambda p: (p / "0/1/1/1").write_bytes(bytes(10 ** 6))),
            ("levels upside down", "levels must become coarser", lambda p: edit("1/.zarray", shape=[40, 48, 56])(p)),
        ]
        for name, expected, change in cases:
            with self.subTest(name):
                line = self.refuse(expected, "info", spoilt(change))
                self.assertIn("bad.zarr", line)
        with self.subTest("a level that is whole is read"):
            path = spoilt(lambda p: (p / "0/1/1/1").write_bytes(b"x"))
            read, _ = self.values_of(path, "--level", 1)
            self.assertTrue((read == values[::2, ::2, ::2]).all())

    def test_sides_of_chunks_may_be_larger_than_anything(self):
        path = self.make("wide.zarr", noise((3, 4, 5), "u1"), image([(1, 1, 1)]), compressor=None)
        described = json.loads((path / "0/.zarray").read_text())
        (path / "0/.zarray").write_text(json.dumps({**described, "chunks": [1, 1, 2 ** 27], "shape": [1, 1, 2 ** 26], "fill_value": 7}))
        shutil.rmtree(path / "0/0")
        done = self.succeed("info", path)
        self.assertIn("values       7 to 7", done.stdout)
        self.assertIn("no chunk of it is there; all of it has the value 7", done.stderr)

    def test_chunks_of_single_voxels(self):
        path = self.make("fine.zarr", noise((3, 4, 5), "u1"), image([(1, 1, 1)]))
        described = json.loads((path / "0/.zarray").read_text())
        (path / "0/.zarray").write_text(json.dumps({**described, "chunks": [1, 1, 1], "shape": [1, 65536, 65536]}))
        self.refuse(r"it has 4.29e\+09 chunks; save it with larger ones", "info", path)

    def test_folders_of_chunks_are_found_where_nobody_speaks_of_them(self):
        values = noise((9, 10, 11), "<u2")
        path = self.make("nested.zarr", values, image([(1, 1, 1)]), (4, 4, 4))
        described = json.loads((path / "0/.zarray").read_text())
        del described["dimension_separator"]
        (path / "0/.zarray").write_text(json.dumps(described))
        self.assertTrue((self.values_of(path)[0] == values).all())

    def test_a_session_speaks_of_the_finest_level_where_that_is_too_long_for_a_texture(self):
        values = numpy.zeros((2, 40, 40, 2304), "u1")
        values[1, 12:24, 10:26, 3:2300] = 200
        path = self.make("long.zarr", values, image([(1, 1, 1, 1), (1, 2, 2, 2)], "czyx"), (1, 40, 40, 64))
        session = self.folder / "s.json"
        session.write_text(json.dumps({"volumeStudioSession": 1, "volume": {"path": str(path), "channel": 1}, "operations": [
            {"op": "seed", "range": [150, 255], "voxels": [[2000, 20, 20]]}, {"op": "grow"}, {"op": "labels", "file": "l.zarr"}]}))
        done = self.succeed("run", session, "-o", self.folder / "out")
        report = json.loads((self.folder / "out" / "report.json").read_text())
        self.assertEqual((report["level"], report["storage"]), (1, "bricks"))
        self.assertIn("made on level 0 and is replayed on level 1", done.stderr)
        grown = zarr.open_group(str(self.folder / "out" / "l.zarr"), "r")["0"][:]
        self.assertTrue(numpy.array_equal(grown == 1, values[1] == 200))

    def test_a_session_without_a_level_keeps_to_the_memory_it_is_given(self):
        values = numpy.zeros((160, 160, 160), "u1")
        values[20:140, 30:90, 40:120] = 200
        path = self.make("room.zarr", values, image([(1, 1, 1), (2, 2, 2)]), (32, 32, 32))
        session = self.folder / "room.json"
        session.write_text(json.dumps({"volumeStudioSession": 1, "volume": {"path": str(path)}, "operations": [
            {"op": "seed", "range": [150, 255], "voxels": [[60, 50, 80]]}, {"op": "grow"}, {"op": "labels", "file": "l.zarr"}]}))
        for options, level in (((), 0), (("--device-memory", "32MiB"), 1), (("--device-memory", "1GiB"), 0),
                               (("--device-memory", "32MiB", "--storage", "dense"), 0)):
            with self.subTest(options):
                out = self.folder / f"out-{'-'.join(options)}"
                done = self.succeed("run", session, "-o", out, *options)
                self.assertEqual(json.loads((out / "report.json").read_text())["level"], level)
                self.assertEqual("made on level 0 and is replayed on level 1" in done.stderr, level == 1)
                grown = zarr.open_group(str(out / "l.zarr"), "r")["0"][:]
                self.assertTrue(numpy.array_equal(grown == 1, values == 200))

    def test_levels_have_the_same_channels(self):
        path = self.make("c.zarr", noise((3, 6, 8, 8), "u1"), image([(1, 1, 1, 1), (1, 2, 2, 2)], "czyx"), (1, 4, 4, 4))
        self.succeed("info", path, "--channel", 2, "--level", 1)
        described = json.loads((path / "1/.zarray").read_text())
        (path / "1/.zarray").write_text(json.dumps({**described, "shape": [1, *described["shape"][1:]]}))
        self.refuse("level 1 has other channels or times", "info", path, "--channel", 2, "--level", 1)

    def test_a_name_may_be_any_bytes_and_a_folder_end_in_a_slash(self):
        scan = self.folder / "a.raw"
        scan.write_bytes(bytes(range(27)))
        odd = os.fsencode(self.folder) + b"/n\xff\n.raw"
        os.rename(scan, odd)
        done = subprocess.run([os.fsencode(self.vstudio), b"convert", odd, os.fsencode(self.folder / "o.zarr") + b"/", b"--raw", b"3x3x3:uint8"],
                              capture_output=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertTrue((zarr.open_group(str(self.folder / "o.zarr"), "r")["0"][:].ravel() == numpy.arange(27)).all())

    def test_options_of_stores_are_for_stores(self):
        scan = self.folder / "a.nrrd"
        self.succeed("phantom", "head", "--size", "20", "-o", scan)
        self.refuse("it is one file; leave out --level", "info", scan, "--level", 1)


if __name__ == "__main__":
    unittest.main(verbosity=1)
