#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Calls vstudio as a person would, rightly and wrongly. usage: commands.py VSTUDIO"""
import gzip
import json
import os
import pathlib
import re
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib

VSTUDIO = sys.argv.pop(1)
SOURCES = pathlib.Path(__file__).parents[2] / "src"


def call(*arguments, **environment):
    return subprocess.run([VSTUDIO, *map(os.fspath, map(as_argument, arguments))], capture_output=True, text=True,
                          errors="replace", timeout=300, env={**os.environ, **environment})


def as_argument(value):
    return value if isinstance(value, (bytes, os.PathLike)) else str(value)


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


def nrrd_floats(path):
    """The values of one of our own NRRD files of 32-bit floats."""
    header, data = pathlib.Path(path).read_bytes().split(b"\n\n", 1)
    assert b"type: float" in header, header
    if b"encoding: gzip" in header:
        data = gzip.decompress(data)
    return list(struct.unpack(f"<{len(data) // 4}f", data))


def write_grey_png(path, width, height, value):
    rows = b"".join(b"\0" + bytes(value(x, y) for x in range(width)) for y in range(height))

    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))

    pathlib.Path(path).write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0)) +
                                   chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


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

    def test_a_picture_becomes_a_sketch(self):
        with tempfile.TemporaryDirectory() as folder:
            picture = pathlib.Path(folder) / "disc.png"
            write_grey_png(picture, 64, 64, lambda x, y: 255 if (x - 31.5) ** 2 + (y - 40.5) ** 2 < 400 else 0)
            result = call("sketch", picture, "--centre", "600,400", "--width", "128")
            self.assertEqual(result.returncode, 0, result.stderr)
            sketch = json.loads(result.stdout)
            self.assertEqual(sketch["shape"], "stencil")
            xs, ys = zip(*sketch["points"])
            self.assertAlmostEqual(min(xs), 560, delta=1.5)
            self.assertAlmostEqual(max(ys), 458, delta=1.5)  # below the middle in the picture, and on the viewport
            write_grey_png(picture, 8, 8, lambda x, y: 0)
            empty = call("sketch", picture, "--centre", "600,400")
            self.assertEqual((empty.returncode, empty.stderr.count("\n")), (1, 1))
            self.assertIn("nothing to cut out", empty.stderr)
            self.assertEqual(call("sketch", picture, "--centre", "nowhere").returncode, 2)

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

    def test_every_command_has_help(self):
        for command in ([], ["info"], ["render"], ["run"], ["grow"], ["sweep"], ["devices"], ["compare"], ["phantom"],
                        ["histogram"], ["stats"], ["bench"]):
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
        for option in ("--azimuth=nan", "--azimuth=inf", "--elevation=nan", "--zoom=nan", "--zoom=0", "--azimuth=1e9"):
            self.expect_error(2, [option.split("=")[0]], "render", self.raw, *self.layout, "-o", picture, option)
        self.expect_error(2, ["--mean"], "compare", picture, picture, "--mean", "nan")
        self.expect_error(2, ["p.jpg", "PNG"], "render", self.raw, *self.layout, "-o", self.folder / "p.jpg")
        grow = ("grow", self.raw, *self.layout, "--seed", "10,10,8", "--range", "100:255", "-o")
        self.expect_error(2, ["l.xyz", ".nrrd"], *grow, self.folder / "l.xyz")
        labels = self.folder / "l.nrrd"
        self.expect_error(2, ["g.raw", ".nrrd"], *grow, labels, "--generations", self.folder / "g.raw")
        self.expect_error(2, ["--generations", "l.nrrd"], *grow, labels, "--generations",
                          self.folder / ".." / self.folder.name / "l.nrrd")
        self.assertFalse(labels.exists())
        self.expect_error(2, ["s.xyz", ".nrrd"], "sweep", "--dims", "8,8,8", "--mask", "circle:3", "--path",
                          "line:0,0,0:1,1,1", "-o", self.folder / "s.xyz")
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
        for seed in ("99,1,1", "10,10,8"):
            self.expect_error(1, ["ramp.raw", "seed"], "grow", self.raw, *self.layout, "--seed", seed, "--range", "1:2",
                              "-o", self.folder / "l.nii.gz")
        os.mkfifo(self.folder / "pipe.nrrd")
        self.expect_error(1, ["pipe.nrrd"], "grow", self.raw, *self.layout, "--seed", "10,10,8", "--range", "100:255",
                          "-o", self.folder / "pipe.nrrd")
        self.assertTrue((self.folder / "pipe.nrrd").is_fifo())
        self.expect_error(1, ["no.json"], "run", self.folder / "no.json", "-o", self.folder / "out")
        self.assertEqual([p.name for p in self.folder.iterdir() if p.name.startswith(".")], [], "no half-written files")

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

    def test_annotations_are_drawn_over_the_picture_and_nowhere_else(self):
        plain, annotated = self.folder / "plain.png", self.folder / "annotated.png"
        command = ("render", self.raw, *self.layout, "--size", "300x260", "--samples", "1", "-o")
        self.assertEqual(call(*command, plain).returncode, 0)
        self.assertEqual(call(*command, annotated, "--annotations").returncode, 0)
        width, height, before = read_png(plain)
        _, _, after = read_png(annotated)
        stride = 1 + 4 * width
        rows = [y for y in range(height) if before[y * stride:(y + 1) * stride] != after[y * stride:(y + 1) * stride]]
        self.assertGreater(len(rows), 20)
        self.assertGreater(min(rows), height // 2, "both stand in the lower corners")

    def test_sampling_is_linear_or_cubic(self):
        linear, cubic = self.folder / "linear.png", self.folder / "cubic.png"
        command = ("render", self.raw, *self.layout, "--size", "120x90", "--samples", "1", "--range", "100:255", "-o")
        self.expect_error(2, ["--sampling", "cubic"], *command, cubic, "--sampling", "quintic")
        self.assertEqual(call(*command, linear).returncode, 0)
        self.assertEqual(call(*command, cubic, "--sampling", "linear").returncode, 0)
        self.assertEqual(call("compare", linear, cubic, "--max", "0").returncode, 0, "linear is the default")
        self.assertEqual(call(*command, cubic, "--sampling", "cubic").returncode, 0)
        self.assertEqual(call("compare", linear, cubic, "--mean", "0.1").returncode, 1)

    def test_backgrounds_are_known_by_name(self):
        picture = self.folder / "p.png"
        command = ("render", self.raw, *self.layout, "--size", "40x30", "--samples", "1", "-o", picture)
        self.expect_error(2, ["background 'pink'", "#RRGGBB"], *command, "--background", "pink")
        self.assertFalse(picture.exists())
        corner = {"white": "ffffffff", "black": "000000ff", "transparent": "00000000", "#102030": "102030ff"}
        for background in ("studio", "white", "black", "transparent", "#102030", "#FFFFFF:#C0D0E0"):
            self.assertEqual(call(*command, "--background", background).returncode, 0, background)
            if background in corner:
                self.assertEqual(read_png(picture)[2][1:5].hex(), corner[background])

    def test_a_device_that_is_no_number_is_named(self):
        result = call("render", self.raw, *self.layout, "-o", self.folder / "p.png", VOLUME_STUDIO_DEVICE="abc")
        self.assertEqual(result.returncode, 1)
        self.assertEqual(len(result.stderr.splitlines()), 1, result.stderr)
        self.assertIn("VOLUME_STUDIO_DEVICE=abc", result.stderr)

    def test_a_level_of_the_log_that_is_not_known_is_said_and_harms_nothing(self):
        result = call("render", self.raw, *self.layout, "-o", self.folder / "p.png", VOLUME_STUDIO_LOG="loud")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("note: VOLUME_STUDIO_LOG=loud is not known; choose notice, performance or debug",
                      result.stderr.splitlines())

    def test_output_that_cannot_be_printed_is_an_error(self):
        for arguments in (["info", self.raw, *self.layout], ["info", self.raw, *self.layout, "--json"], ["--help"]):
            with open("/dev/full", "w") as full:
                result = subprocess.run([VSTUDIO, *arguments], stdout=full, stderr=subprocess.PIPE, text=True)
            self.assertEqual(result.returncode, 1, arguments)
            self.assertEqual(len(result.stderr.splitlines()), 1, result.stderr)

    def with_shader(self, shader, text, *arguments):
        """What a command says last, which fails, with another shader in the place of its own."""
        stub = self.folder / "shaders" / shader
        stub.parent.mkdir(parents=True, exist_ok=True)
        stub.write_text(text)
        result = call(*arguments, VOLUME_STUDIO_SHADER_DIR=str(self.folder / "shaders"))
        stub.unlink()
        self.assertEqual(result.returncode, 1, result)
        self.assertTrue(all(line.startswith("note: ") for line in result.stderr.splitlines()[:-1]), result.stderr)
        return result.stderr.splitlines()[-1]

    def test_a_shader_without_a_uniform_that_is_set_fails_every_command_and_is_named(self):
        picture, labels, solid = (self.folder / name for name in ("p.png", "l.nrrd", "s.nrrd"))
        for shader, arguments in (
                ("render/shaders/classify_cells.comp", ("render", self.raw, *self.layout, "-o", picture)),
                ("segment/shaders/store_generation.comp",
                 ("grow", self.raw, *self.layout, "--seed", "10,10,8", "--range", "100:255", "-o", labels)),
                ("sculpt/shaders/deposit_points.comp", ("sweep", "--dims", "16,16,16", "--mask", "circle:3", "--path",
                                                        "line:8,8,4:8,8,12", "-o", solid))):
            said = self.with_shader(shader, "layout(local_size_x = 64) in;\nvoid main() {}\n", *arguments)
            self.assertIn(f"{shader} has no uniform '", said)
        self.assertFalse(any(p.exists() for p in (picture, labels, solid)))

    def test_opengl_errors_fail_commands_and_sessions(self):
        # A uniform that is no array: setting more than one of its elements is an OpenGL error.
        def without_array(shader, name):
            text = (SOURCES / shader).read_text()
            return re.sub(name + r"\[[^\]]*\]", name, text)

        solid = self.folder / "s.nrrd"
        said = self.with_shader("sculpt/shaders/convolve_tiles.comp",
                                without_array("sculpt/shaders/convolve_tiles.comp", "taps"),
                                "sweep", "--dims", "16,16,16", "--mask", "circle:3", "--path", "line:8,8,4:8,8,12", "-o", solid)
        self.assertIn("OpenGL errors", said)
        self.assertFalse(solid.exists())
        planes = [{"point": [0, 0, z], "normal": [0, 0, 1]} for z in (5, 6)]
        said = self.with_shader("sculpt/shaders/cut_half_spaces.comp",
                                without_array("sculpt/shaders/cut_half_spaces.comp", "planes"),
                                *self.session_call({"op": "clip", "planes": planes}))
        self.assertIn("OpenGL errors", said)
        report = json.loads((self.folder / "out" / "report.json").read_text())
        self.assertIn("OpenGL errors", report["error"])

    def session_call(self, *operations, **volume):
        """Writes s.json and gives the arguments that replay it."""
        session = self.folder / "s.json"
        session.write_text(json.dumps({"volumeStudioSession": 1, "operations": operations,
                                       "volume": {"path": "ramp.raw", "raw": "24x20x16:uint8", **volume}}))
        return "run", session, "-o", self.folder / "out"

    def test_a_session_writes_into_folders_and_reports(self):
        small = {"op": "picture", "size": [32, 24], "samples": 1}
        replay = self.session_call({**small, "file": "a/b.png"}, {"op": "labels", "file": "a/c/l.nrrd"})
        result = call(*replay)
        self.assertEqual(result.returncode, 0, result.stderr)
        out = self.folder / "out"
        self.assertEqual(read_png(out / "a" / "b.png")[:2], (32, 24))
        self.assertTrue((out / "a" / "c" / "l.nrrd").exists())
        report = json.loads((out / "report.json").read_text())
        self.assertTrue(report["complete"])
        self.assertEqual(len(report["operations"]), 2)
        # A replay that fails leaves what it has done and why it ended, not the older report.
        self.expect_error(1, ["operation 2 (undo)"], *self.session_call({**small, "file": "b.png"}, {"op": "undo"}))
        report = json.loads((out / "report.json").read_text())
        self.assertFalse(report["complete"])
        self.assertEqual([entry["name"] for entry in report["operations"]], ["picture"])
        self.assertIn("nothing to undo", report["error"])

    def test_a_session_whose_volume_cannot_be_opened_leaves_no_folder(self):
        self.expect_error(1, ["gone.raw"], *self.session_call(path="gone.raw"))
        self.expect_error(1, ["ramp.raw"], *self.session_call(raw="24x20x17:uint8"))
        self.assertFalse((self.folder / "out").exists())

    def test_a_session_runs_on_another_volume(self):
        replay = self.session_call(path="gone.raw", checksum="0000000000000000", frame=3, series="1.2.3")
        other = self.folder / "other.raw"
        other.write_bytes(self.raw.read_bytes())
        result = call(*replay, "--volume", other)  # headerless too, so the session's layout holds
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("is not the volume", result.stderr)
        grid = self.folder / "grid.nrrd"
        self.assertEqual(call("grow", self.raw, *self.layout, "--seed", "10,10,8", "--range", "100:255", "-o",
                              grid).returncode, 0)
        result = call(*replay, "--volume", grid)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("does not fit it", result.stderr)
        self.expect_error(1, ["grid.nrrd", "--frame"], *replay, "--volume", grid, "--frame", "2")
        other.write_bytes(bytes(8 * 8 * 8))
        self.expect_error(1, ["other.raw", "512"], *replay, "--volume", other)
        self.assertEqual(call(*replay, "--volume", other, "--raw", "8x8x8:uint8").returncode, 0)
        self.expect_error(2, ["8x8"], *replay, "--volume", other, "--raw", "8x8")
        self.expect_error(1, ["s.json", "checksum"], *self.session_call(checksum="0000000000000000"))

    def test_names_that_are_not_utf8_do_no_harm(self):
        other = os.path.join(os.fsencode(self.folder), b"h\xff.raw")
        with open(other, "wb") as file:
            file.write(self.raw.read_bytes())
        result = call(*self.session_call(), "--volume", other)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("h\ufffd.raw", json.loads((self.folder / "out" / "report.json").read_text())["volume"])

    def test_wrong_sessions_name_operation_and_member(self):
        session = self.folder / "s.json"
        with_operations = self.session_call
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
        self.expect_error(1, ["s.json", "volume.raw", "24x20"], *with_operations(raw="24x20"))
        self.expect_error(1, ["s.json", "volume.path"], *with_operations(path=""))
        self.expect_error(1, ["operation 1", "report.json"], *with_operations({"op": "picture", "file": "report.json"}))
        self.expect_error(1, ["operation 1", "not a folder's"], *with_operations({"op": "picture", "file": "a/"}))
        self.expect_error(1, ["out of bounds"], *with_operations(
            {"op": "seed", "strokes": [{"shape": "polyline", "points": [[1, 1e9], [2, 2]]}]}))
        session.write_text('{"volumeStudioSession": 1e999, "volume": {"path": "x"}, "operations": []}')
        self.expect_error(1, ["s.json", "JSON"], "run", session, "-o", self.folder / "out")
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
        link = self.folder / "link.nrrd"
        link.symlink_to("labels.nrrd")
        seeds = call("grow", self.raw, *self.layout, "--seed", "6,5,4", "--range", "100:255", "--steps", "0", "-o", link)
        self.assertEqual(seeds.returncode, 0)
        self.assertTrue(link.is_symlink(), "a link stays, its target is replaced")
        self.assertEqual(sum(json.loads(call("info", labels, "--json").stdout)["histogram"]["counts"][128:]), 1)

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

    def test_devices_lists_one(self):
        result = call("devices")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("OpenGL", result.stdout)


if __name__ == "__main__":
    unittest.main(verbosity=2)
