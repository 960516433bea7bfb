#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Replays the sessions of examples/chapter3 and examples/tools.json with small pictures, and checks what they are meant to
show and what undo and redo of them hold. usage: chapter3.py VSTUDIO ROOT"""
import json
import pathlib
import subprocess
import sys
import tempfile

vstudio, root = sys.argv[1], pathlib.Path(sys.argv[2])
CUTS = {"peel", "drill", "laser", "sweep", "scissors", "clip", "keep connected"}


def replay(path, folder, takes_back):
    session = json.loads(path.read_text())
    volume = session["volume"].get("path")
    if volume and not pathlib.Path(volume).exists():
        sys.exit(f"FAILED: {path.name}: {volume} is not there (Debian package mricron-data)")
    for operation in session["operations"]:
        if operation["op"] == "picture":
            operation.update(size=[160, 160], samples=1)
    if takes_back:
        session["operations"] = [o for o in session["operations"] if o["op"] != "picture"]
        undoable = sum(o["op"] not in ("view", "undo", "redo") for o in session["operations"])
        session["operations"] += [{"op": "undo"}] * undoable
    copy = folder / path.name
    copy.write_text(json.dumps(session))
    out = folder / (path.stem + ("_back" if takes_back else ""))
    result = subprocess.run([vstudio, "run", copy, "-o", out], capture_output=True, text=True)
    assert result.returncode == 0, (path.name, result.stderr)
    report = json.loads((out / "report.json").read_text())
    assert report["complete"], path.name
    return report


def cuts(report):
    return [e["voxels"] for e in report["operations"] if e["name"] in CUTS]


reports = {}
held = {False: [], True: []}
with tempfile.TemporaryDirectory() as name:
    folder = pathlib.Path(name)
    for path in sorted((root / "examples" / "chapter3").glob("*.json")) + [root / "examples" / "tools.json"]:
        for takes_back in (False, True):
            report = replay(path, folder, takes_back)
            if path.stem not in ("precision_8", "precision_32"):
                held[takes_back].append(report["undo"])
            if not takes_back:
                reports[path.stem] = report
                assert all(voxels > 500 for voxels in cuts(report)), (path.name, cuts(report))
        pictures = [p.read_bytes() for p in (folder / path.stem).glob("*.png")]
        # Some filters differ by less than a small picture shows.
        assert len(set(pictures)) > 0.6 * len(pictures) or not pictures, f"{path.name}: pictures are the same"

# Planes get thicker with the radius of the radiation (thesis, section 3.6.1). Each is swept as two ellipses.
first = cuts(reports["crossing_ellipses"])
assert first[0] < first[2] < first[4], first
# Filters change the edge and no more (what is counted holds its faint fringe too).
for stem in ("helix_filters", "filter_widths"):
    sizes = cuts(reports[stem])[:11 if stem == "helix_filters" else 4]  # the widest reaches far
    assert max(sizes) < 1.25 * min(sizes), (stem, sizes)
exact = {bits: cuts(reports[f"precision_{bits}"])[0] for bits in (8, 16, 32)}
assert exact[8] < exact[16] <= exact[32], exact  # coarse steps hold no faint energies
joint = cuts(reports["pipe_joint"])
assert len(joint) == 4 and joint[0] < joint[2], "radiation has a soft edge around what is projected"

for takes_back, what in ((False, "to undo"), (True, "to redo")):
    each = [u["bytesPerChangedVoxel"] for u in held[takes_back] if u["changedVoxels"]]
    mean = sum(each) / len(each)
    print(f"{what}: {mean:.2f} bytes per changed voxel on average, {min(each):.2f} to {max(each):.2f}")
    assert mean <= 1.6, (what, each)
