#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""vstudio devices --check: its report is right, short in coming and names nobody, and a fault that is planted in a stage's shader is
found and named.
usage: devices.py VSTUDIO SOURCE_ROOT"""
import getpass
import json
import os
import pathlib
import re
import resource
import socket
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(sys.argv.pop(2))
VSTUDIO = sys.argv.pop(1)

# A fault for each stage that a shader has a part in: the shader, what stands in it, and what is put there.
FAULTS = {
    "order of work": ("gl/shaders/fill_words.comp", "] = value", "] = value | 1u"),
    "sampling between voxels": ("field/shaders/scene.glsl", "storedAt(sampledFromVoxel(p)) * storedScale().x",
                                "storedAt(sampledFromVoxel(p)) * 0.999 * storedScale().x"),
    "intensity histogram": ("field/shaders/count_histogram.comp", "(value - valueRange.x) * scale)",
                            "(value - valueRange.x) * scale + 0.05)"),
    "gradient magnitudes": ("field/shaders/count_gradients.comp", "(0.5 * vec3(right", "(0.501 * vec3(right"),
    "ranges of macrocells": ("field/shaders/summarize_cells.comp", "first + 4", "first + 3"),
    "distances of macrocells": ("render/shaders/spread_cells.comp", "bits | bits << 1 | bits >> 1", "bits | bits << 1"),
    "smoothed values": ("field/shaders/smooth_values.comp", "vec2(value, 1.0)", "vec2(value * 1.0001, 1.0)"),
    "transfer function tables": ("render/shaders/classification.glsl", "? c.a : 0.0;\n    return c;\n}\n\n#if",
                                 "? 0.97 * c.a : 0.0;\n    return c;\n}\n\n#if"),
    "point radiation": ("sculpt/shaders/convolve_tiles.comp", "(1.0 / FIXED_ONE)", "(1.003 / FIXED_ONE)"),
    "drill and undo": ("sculpt/shaders/combine_sculpture.comp", "isRestore != 0 ? min(before, remains)", "isRestore != 0 ? before"),
    "peel": ("sculpt/shaders/generate_tool_points.comp", "max(forwards * dot(", "0.95 * max(forwards * dot("),
    "clip and outline cut": ("sculpt/shaders/cut_solid.glsl", "1.5976", "1.55"),
    "growth": ("segment/shaders/constraints.glsl", "max(voxel - 1, 0)", "max(voxel - 2, 0)"),
    "seeds on surfaces": ("segment/shaders/find_seeds.comp", "points[i].voxel.w < 0.5", "points[i].voxel.w < -0.5"),
    "memberships of segments": ("segment/shaders/smooth_xy.comp", "bits >> 6 & 1u", "bits >> 5 & 1u"),
    "surfaces": ("field/shaders/scene.glsl", "value - range.x + valueScale.w", "value - range.x + 0.1"),
    "faces of cuts": ("field/shaders/scene.glsl", "0.5 - sculpture - 1e-6", "0.505 - sculpture"),
    "surfaces of segments": ("field/shaders/scene.glsl", "textureFromVoxel(p), 0.0).rg; }", "textureFromVoxel(p), 0.0).rg + 0.002; }"),
    "brightest places": ("render/shaders/maximum.glsl", "best.t = better ? t : best.t;", "best.t = better ? t + 0.3 : best.t;"),
    "MIP pictures": ("render/shaders/bound_slabs.comp", "top = max(top,", "top = min(top,"),
    "X-ray pictures": ("render/shaders/seen_along.glsl", "return sum * lattice.x;", "return sum * lattice.x * 1.03;"),
    "volume pictures": ("render/shaders/composite.glsl", "opacityOfPart(c.a, 2.0 * steps)", "opacityOfPart(c.a, 1.8 * steps)"),
    "skipping of empty space": ("render/shaders/rays.glsl", "ivec3 upper = cell + distance;", "ivec3 upper = cell + distance + 1;"),
    "islands and solids": ("sculpt/shaders/cut_islands.comp", "lessThanEqual(abs(offset), ivec2(1))", "lessThanEqual(abs(offset), ivec2(0))"),
    "pasted parts": ("render/shaders/seen.glsl", "one.front = other.front.a > one.front.a ? other.front : one.front;", ""),
    "light": ("render/shaders/average_occlusion.comp", "kInTheWay = 0.6", "kInTheWay = 0.5"),
    "fill": ("field/shaders/fill.glsl", "back = across * cell.part.z", "back = across * (cell.part.z + 0.01)"),
    "marks": ("field/shaders/marks.glsl", "* across * part.z", "* across * (part.z + 0.01)"),
    "bricks": ("field/shaders/bricks.glsl", "+ inBrick + 0.5)", "+ inBrick + 0.6)"),
    "slices": ("render/shaders/draw_slice.comp", "(1.0 - f.x) * (1.0 - f.y)", "0.97 * (1.0 - f.x) * (1.0 - f.y)"),
}
WITHOUT_SHADER = {"upload and read-back"}


class Devices(unittest.TestCase):
    def setUp(self):
        self.holder = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.holder.name)
        self.json = self.folder / "report.json"

    def tearDown(self):
        self.holder.cleanup()

    def check(self, *arguments, **variables):
        return subprocess.run([VSTUDIO, "devices", "--check", "--json", self.json, *arguments], capture_output=True, text=True,
                              timeout=600, env={**os.environ, **variables})

    def stages(self):
        return {stage["name"]: stage for stage in json.loads(self.json.read_text())["stages"]}

    # Puts another shader in the place of one, with the folder of its own that the program takes it from.
    def plant(self, shader, text):
        path = self.folder / "shaders" / shader
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
        return {"VOLUME_STUDIO_SHADER_DIR": str(self.folder / "shaders")}

    def plant_fault(self, stage):
        shader, right, wrong = FAULTS[stage]
        text = (ROOT / "src" / shader).read_text(encoding="utf-8")
        self.assertIn(right, text, shader)
        return self.plant(shader, text.replace(right, wrong))

    def expect_nobody_named(self, report):
        for person_or_place in (getpass.getuser(), socket.gethostname()):
            self.assertNotIn(person_or_place, re.findall(r"[\w.-]+", report))
        for path in (pathlib.Path.cwd(), pathlib.Path.home(), pathlib.Path(VSTUDIO).parent, self.folder, ROOT):
            self.assertNotIn(f"{path}/", report)
        # Drivers may have slashes in their names; what the program says has none.
        own = [line for line in report.splitlines() if not line.startswith(("vendor:", "renderer:", "version:"))]
        self.assertNotRegex("\n".join(own), r"/|\\|\.(comp|glsl|cpp|json)\b")

    def test_all_stages_are_right_on_this_device(self):
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        result = self.check()
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        self.assertEqual(result.stderr, "")
        report = json.loads(self.json.read_text())
        self.assertTrue(report["ok"])
        self.assertGreaterEqual(len(report["stages"]), 28)
        for stage in report["stages"]:
            self.assertTrue(stage["ok"], stage)
            self.assertGreater(stage["values"], 0, stage)
            self.assertRegex(result.stdout, rf"(?m)^{re.escape(stage['name'])} +ok ")
        lines = result.stdout.splitlines()
        self.assertRegex(lines[-1], rf"^all {len(report['stages'])} stages are right on this device")
        for said in ("vendor: ", "renderer: ", "version: ", "textures: ", "memory: ", "groups: ", "bindings: "):
            self.assertTrue(any(line.startswith(said) for line in lines), said)
        self.expect_nobody_named(result.stdout)
        self.expect_nobody_named(json.dumps(report["stages"]))
        # Of processors: other programs may leave it little of them.
        self.assertLess(after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, 60)

    def test_a_planted_fault_is_found_in_its_stage_and_no_other(self):
        result = self.check(**self.plant_fault("intensity histogram"))
        self.assertEqual(result.returncode, 1, result.stdout)
        self.assertEqual({name for name, stage in self.stages().items() if not stage["ok"]}, {"intensity histogram"})
        self.assertRegex(result.stdout.splitlines()[-1], r"^1 of \d+ stages are wrong on this device: intensity histogram \(")
        self.assertRegex(result.stdout, r"intensity histogram +WRONG .*\n +\d+ of \d+ values differ; the worst of counts of \w+: off by")
        self.assertEqual(len(result.stderr.splitlines()), 1, result.stderr)
        self.assertIn("computes something wrong", result.stderr)

    def test_every_stage_can_fail(self):
        self.assertEqual(self.check().returncode, 0)
        self.assertEqual(set(self.stages()), set(FAULTS) | WITHOUT_SHADER)
        for stage in FAULTS:
            with self.subTest(stage):
                result = self.check("--stage", stage, **self.plant_fault(stage))
                self.assertEqual(result.returncode, 1, result.stdout)
                self.assertGreater(self.stages()[stage]["wrong"], 0)
                self.assertIn(stage, result.stdout.splitlines()[-1])
                (self.folder / "shaders" / FAULTS[stage][0]).unlink()

    def test_a_shader_that_does_not_compile_fails_its_stage_without_a_path(self):
        result = self.check("--stage", "slices", "--stage", "intensity histogram",
                            **self.plant("render/shaders/draw_slice.comp", "void main() { nowhere(); }\n"))
        self.assertEqual(result.returncode, 1)
        self.assertEqual({name: stage["ok"] for name, stage in self.stages().items()},
                         {"slices": False, "intensity histogram": True})
        self.assertIn("ended early: ", result.stdout)
        self.assertIn("draw_slice", result.stdout)
        self.expect_nobody_named(result.stdout)

    def test_opengl_errors_fail_a_stage(self):
        text = (ROOT / "src/sculpt/shaders/cut_half_spaces.comp").read_text()
        result = self.check("--stage", "clip and outline cut",
                            **self.plant("sculpt/shaders/cut_half_spaces.comp", text.replace("planes[MAX_PLANES]", "planes")
                                         .replace("planes[n]", "planes")))
        self.assertEqual(result.returncode, 1, result.stdout)
        self.assertGreater(self.stages()["clip and outline cut"]["glErrors"], 0)
        self.assertIn("OpenGL errors", result.stdout)

    def test_wrong_usage_is_said(self):
        for arguments, mention in ((("--json", self.json), "--check"), (("--stage", "slices"), "--check"),
                                   (("--check", "--stage", "sliced"), "slices"),
                                   (("--check", "--json", self.folder), self.folder.name)):
            result = subprocess.run([VSTUDIO, "devices", *arguments], capture_output=True, text=True, timeout=300)
            self.assertNotEqual(result.returncode, 0, arguments)
            self.assertEqual(len(result.stderr.splitlines()), 1, result.stderr)
            self.assertIn(mention, result.stderr)
            self.assertNotIn("renderer:", result.stdout, "nothing is checked first")


if __name__ == "__main__":
    unittest.main()
