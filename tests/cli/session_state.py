#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Sessions with state, as a person would use them: saved, opened, checked, edited, damaged, killed while they are saved.

usage: session_state.py VSTUDIO SOURCE
"""

import importlib.util
import json
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

VSTUDIO, SOURCE = sys.argv[1], Path(sys.argv[2])
VERSION1 = SOURCE / "tests/data/sessions/version1"
CH2 = Path("/usr/share/mricron/templates/ch2.nii.gz")


def vstudio(*arguments, code=0):
    done = subprocess.run([VSTUDIO, *map(str, arguments)], capture_output=True, text=True, check=False)
    assert done.returncode == code, f"{arguments}: {done.returncode}, {done.stdout}{done.stderr}"
    return done.stdout + done.stderr


def loaded(path):
    spec = importlib.util.spec_from_file_location(path.stem, path)
    module = importlib.util.module_from_spec(spec)
    sys.path.insert(0, str(path.parent))
    spec.loader.exec_module(module)
    return module


def session_file(path, operations, volume=None):
    path.write_text(json.dumps({"volumeStudioSession": 2, "volume": volume or {"phantom": "head", "dims": [80, 90, 80]},
                                "operations": operations}))
    return path


MASK = {"shape": "ellipse", "points": [[500, 250], [730, 480]]}
OPERATIONS = [
    {"op": "view", "range": [60, 255], "camera": {"azimuth": 30, "elevation": 20}},
    {"op": "peel", "layers": 8, "mask": MASK},
    {"op": "drill", "depthMax": 12, "mask": {"shape": "ellipse", "points": [[560, 300], [640, 380]]}},
    {"op": "seed", "voxels": [[40, 45, 40]], "range": [60, 255]},
    {"op": "grow", "generations": 20},
    {"op": "measure", "kind": "distance", "points": [[10, 10, 10], [30, 40, 10]]},
    {"op": "clip", "planes": [{"point": [0, 0, 30], "normal": [0, 0, 1]}]},
    {"op": "paste", "move": [60, 0, 0]},
    {"op": "undo"},
]


def test_saved_and_opened(folder):
    first = session_file(folder / "first.json", OPERATIONS)
    saved = folder / "saved.json"
    vstudio("run", first, "-o", folder, "--save", saved, "--picture", "replayed.png", "--size", "400x300")
    assert (folder / "saved.json.state").exists()
    content = json.loads(saved.read_text())
    assert content["volumeStudioSession"] == 2 and content["state"], content
    said = vstudio("check", saved)
    assert "equal, to the byte" in said, said
    vstudio("run", saved, "-o", folder, "--state", "--picture", "opened.png", "--size", "400x300")
    assert (folder / "opened.png").read_bytes() == (folder / "replayed.png").read_bytes()
    # Figures come from the state too: with the log emptied of what grows they are the same only if nothing is replayed.
    figures = vstudio("stats", saved)
    assert "Segment 1" in figures, figures


def test_saved_again(folder):
    """A session that was opened from its state, and saved, is the one that it was."""
    saved = folder / "saved.json"
    again = folder / "again.json"
    vstudio("run", saved, "-o", folder, "--state", "--save", again)
    assert "equal, to the byte" in vstudio("check", again)


def test_edited_and_missing(folder):
    saved = folder / "saved.json"
    edited = folder / "edited.json"
    content = json.loads(saved.read_text())
    content["operations"][1]["layers"] = 3
    edited.write_text(json.dumps(content))
    shutil.copy(folder / "saved.json.state", folder / "edited.json.state")
    said = vstudio("check", edited, code=1)
    assert "has been changed since" in said and "\n" not in said.split("vstudio: ")[1].strip(), said
    assert "done again" in vstudio("stats", edited)  # it is replayed
    (folder / "edited.json.state").unlink()
    assert "is not there" in vstudio("check", edited, code=1)
    plain = session_file(folder / "plain.json", OPERATIONS)
    assert "no state" in vstudio("check", plain)
    assert "has no state" in vstudio("run", plain, "-o", folder, "--state", code=1)


def test_other_volume(folder):
    saved = folder / "saved.json"
    vstudio("phantom", "head", "-o", folder / "other.nrrd", "--size", "80x90x80", "--noise", 3)
    said = vstudio("stats", saved, "--volume", folder / "other.nrrd")
    assert "done again" in said, said


def test_killed_while_saving(folder):
    """Whenever it is killed, the session of before or the new one opens, with its state."""
    target = folder / "killed.json"
    first = session_file(folder / "one.json", OPERATIONS[:3])
    second = session_file(folder / "two.json", OPERATIONS)
    vstudio("run", first, "-o", folder, "--save", target)
    counts = {len(json.loads(target.read_text())["operations"])}
    old = target.read_text()
    began = time.monotonic()
    vstudio("run", second, "-o", folder, "--save", folder / "timed.json")
    whole = time.monotonic() - began
    kept = replaced = 0
    for step in range(16):
        process = subprocess.Popen([VSTUDIO, "run", second, "-o", folder, "--save", target], stdout=subprocess.DEVNULL,
                                   stderr=subprocess.DEVNULL)
        # The saving is the last that it does.
        try:
            process.wait(whole * (0.8 + 0.4 * step / 16))
        except subprocess.TimeoutExpired:
            process.send_signal(signal.SIGKILL)
            process.wait()
        said = vstudio("check", "--no-replay", target)
        assert "whole and fits" in said, said
        if target.read_text() == old:
            kept += 1
        else:
            replaced += 1
            vstudio("run", first, "-o", folder, "--save", target)
    print(f"killed while saving: {kept} times the old one was there, {replaced} times the new one", counts)


def test_version_1(folder):
    """What the program of before sessions with state wrote still does what it did."""
    loaded(SOURCE / "tests/desktop/phantom.py").write_ball_head(folder / "ball.nrrd")
    loaded(SOURCE / "tests/desktop/test_slices.py").write_head(folder / "slices.nrrd")
    volumes = {"history": folder / "ball.nrrd", "shapes": folder / "ball.nrrd", "slices": folder / "slices.nrrd",
               "tools": CH2, "workflow": CH2, "from_nothing": None}
    for name, wanted in json.loads((VERSION1 / "voxels.json").read_text()).items():
        volume = ["--volume", volumes[name]] if volumes[name] else []
        if volume and not volume[1].exists():
            print(f"skipped: {volume[1]} is not installed")
            continue
        saved = folder / f"{name}_2.json"
        vstudio("run", VERSION1 / f"{name}.json", "-o", folder / name, "--save", saved, *volume)
        report = json.loads((folder / name / "report.json").read_text())
        for (operation, voxels), entry in zip(wanted, report["operations"], strict=True):
            assert entry["name"] == operation, (name, entry)
            # Another device cuts a little differently where rays graze a surface.
            assert abs(entry["voxels"] - voxels) <= 10 + 0.01 * voxels, (name, entry, voxels)
        assert json.loads(saved.read_text())["volumeStudioSession"] == 2
        assert "equal, to the byte" in vstudio("check", saved), name


def main():
    tests = [value for name, value in globals().items() if name.startswith("test_")]
    with tempfile.TemporaryDirectory() as folder:
        for test in tests:
            test(Path(folder))
            print("passed:", test.__name__)


if __name__ == "__main__":
    main()
