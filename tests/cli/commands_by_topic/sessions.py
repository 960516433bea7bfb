# SPDX-License-Identifier: Apache-2.0
"""Sessions: what they write, on which volume, and how wrong ones are refused."""
import json
import os

from commands_by_topic.case import Case, call, read_png


class Sessions(Case):
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

    def journal(self, name, *lines):
        """A journal as a window that was killed leaves it, of two cuts and what `lines` add."""
        folder = self.folder / "state" / "volume-studio" / "journals"
        folder.mkdir(parents=True, exist_ok=True)
        volume = self.folder / "box.nrrd"
        if not volume.exists():
            call("grow", self.raw, *self.layout, "--seed", "6,5,4", "--range", "100:255", "-o", volume)
        clip = [{"op": "clip", "planes": [{"point": [x, 0, 0], "normal": [1, 0, 0]}]} for x in (5, 7)]
        (folder / name).write_text("\n".join([
            json.dumps({"volumeStudioJournal": 1, "volume": {"path": str(volume)}, "precision": 16}),
            *(json.dumps({"n": n, "operation": operation}) for n, operation in enumerate(clip)), *lines]) + "\n")
        return folder / name

    def recover(self, *arguments):
        result = call("recover", *arguments, XDG_STATE_HOME=str(self.folder / "state"))
        return result.returncode, result.stdout, result.stderr

    def test_lost_work_becomes_sessions(self):
        out = self.folder / "out"
        out.mkdir()
        code, said, _ = self.recover()
        self.assertEqual((code, "nothing to recover" in said), (0, True))
        whole, torn = self.journal("1.jsonl"), self.journal("2.jsonl", '{"n":2,"opera')
        code, said, _ = self.recover("--list")
        self.assertEqual(code, 0)
        for word in ("1.jsonl", "2.jsonl", "box.nrrd", "2 edits"):
            self.assertIn(word, said)
        self.assertTrue(whole.exists() and torn.exists(), "a list changes nothing")
        code, said, _ = self.recover("1.jsonl", "-o", out, "--keep")
        self.assertEqual(code, 0)
        self.assertTrue(whole.exists())
        code, said, _ = self.recover("-o", out)
        self.assertEqual(code, 0)
        self.assertFalse(whole.exists() or torn.exists(), "what is recovered is not offered again")
        sessions = sorted(path.name for path in out.iterdir())
        self.assertEqual(sessions, ["box-recovered-2.json", "box-recovered-3.json", "box-recovered.json"])
        for name in sessions:
            session = json.loads((out / name).read_text())
            self.assertEqual([operation["op"] for operation in session["operations"]], ["clip", "clip"])
            self.assertEqual(call("run", out / name, "-o", self.folder / "replayed").returncode, 0)

    def test_what_cannot_be_recovered_is_said_and_stays(self):
        bad = self.journal("bad.jsonl")
        bad.write_text("no journal\n")
        code, _, said = self.recover("-o", self.folder)
        self.assertEqual(code, 1)
        self.assertIn("1 of 1 journals cannot be recovered", said)
        self.assertTrue(bad.exists())
        code, _, said = self.recover("gone.jsonl")
        self.assertEqual((code, said.count("\n")), (1, 1))
        self.assertIn("gone.jsonl", said)
        good = self.journal("good.jsonl")
        code, _, said = self.recover("good.jsonl", "-o", self.folder / "nowhere")
        self.assertEqual((code, said.count("\n")), (1, 1))
        self.assertIn("nowhere", said)
        self.assertTrue(good.exists(), "the work is in the journal as long as it is nowhere else")
