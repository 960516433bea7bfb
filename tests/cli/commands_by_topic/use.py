# SPDX-License-Identifier: Apache-2.0
"""Help, wrong use, devices, and what goes wrong with them."""
import os
import subprocess

from commands_by_topic.case import Case, VSTUDIO, call


class Use(Case):
    def test_every_command_has_help(self):
        for command in ([], ["info"], ["render"], ["run"], ["grow"], ["sweep"], ["devices"], ["compare"], ["phantom"],
                        ["histogram"], ["stats"], ["bench"], ["experiments"], ["reduce"], ["recover"]):
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

    def test_pipes_are_no_input(self):
        """A pipe that nobody writes to would be waited for without end."""
        pipe = self.folder / "pipe.nrrd"
        os.mkfifo(pipe)
        picture = self.folder / "p.png"
        header = self.folder / "detached.nhdr"
        header.write_text("NRRD0004\ntype: uint8\ndimension: 3\nsizes: 4 4 4\nencoding: raw\ndata file: pipe.nrrd\n")
        for arguments in (["info", pipe], ["info", header], ["run", pipe, "-o", self.folder / "out"], ["check", pipe],
                          ["render", self.raw, *self.layout, "-o", picture, "--tf", pipe],
                          ["sketch", pipe, "--centre", "9,9"], ["compare", pipe, pipe], ["stats", pipe, "--volume", self.raw, *self.layout],
                          ["sweep", "--dims", "8,8,8", "--mask", "circle:3", "--path", f"recorded:{pipe}", "-o",
                           self.folder / "s.nrrd"],
                          ["sweep", "--dims", "8,8,8", "--mask", f"image:{pipe},3", "--path", "line:0,0,0:1,1,1", "-o",
                           self.folder / "s.nrrd"]):
            with self.subTest(arguments=arguments[:1]):
                self.expect_error(1, ["pipe.nrrd"], *arguments)

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

    def test_devices_lists_one(self):
        result = call("devices")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("OpenGL", result.stdout)
