# SPDX-License-Identifier: Apache-2.0
"""Pictures: what is drawn, on what, and with what over it; and sketches from pictures."""
import json
import pathlib
import tempfile

from commands_by_topic.case import Case, call, read_png, write_grey_png


class Pictures(Case):
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
