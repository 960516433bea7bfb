# SPDX-License-Identifier: Apache-2.0
"""What a fault of a shader does to commands and sessions."""
import json
import re

from commands_by_topic.case import Case, SOURCES, call


class DeviceErrors(Case):
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
                ("segment/shaders/write_labels.comp",
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
