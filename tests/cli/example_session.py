#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Replays the example session on the real head and checks what it leaves. usage: example_session.py VSTUDIO ROOT"""
import gzip
import json
import pathlib
import subprocess
import sys
import tempfile

vstudio, root = sys.argv[1], pathlib.Path(sys.argv[2])
session = json.loads((root / "examples" / "open_head.json").read_text())
if not pathlib.Path(session["volume"]["path"]).exists():
    sys.exit(f"FAILED: {session['volume']['path']} is not there (Debian package mricron-data)")


def replay(folder):
    small = json.loads(json.dumps(session))
    for operation in small["operations"]:
        if operation["op"] == "picture":  # the operations are the point here, not the pictures' size
            operation.update(size=[246, 174], samples=1)
    (folder / "session.json").write_text(json.dumps(small))
    result = subprocess.run([vstudio, "run", folder / "session.json", "-o", folder / "out"], capture_output=True, text=True)
    assert result.returncode == 0, result.stderr
    report = json.loads((folder / "out" / "report.json").read_text())
    undo = report["undo"]
    assert undo["changedVoxels"] > 100000 and 0 < undo["bytesPerChangedVoxel"] <= 1.6, undo
    assert undo["bytesInFile"] == 0 and undo["bytesInMemory"] > 0, undo
    return report["operations"], gzip.decompress((folder / "out" / "brain.nii.gz").read_bytes())[352:]


with tempfile.TemporaryDirectory() as a, tempfile.TemporaryDirectory() as b:
    report, labels = replay(pathlib.Path(a))
    again, labels_again = replay(pathlib.Path(b))
    pictures = {p.name: p.read_bytes() for p in (pathlib.Path(a) / "out").glob("*.png")}

assert [e["name"] for e in report] == [o["op"] for o in session["operations"]], "one entry per operation"
assert sum(e["milliseconds"] for e in report) > 0, "the operations have taken time"
assert len(pictures) == sum(o["op"] == "picture" for o in session["operations"])
assert len(set(pictures.values())) == len(pictures), "no two pictures are the same"
cut = {e["name"]: e["voxels"] for e in report if e["name"] in ("drill", "undo", "peel")}
assert cut["drill"] == cut["undo"] > 1000 and cut["peel"] > 100000, cut
assert labels == labels_again, "a replay gives the same labels"
grown = labels.count(1)
print(f"grown: {grown} voxels")
# The brain of this head has 1.65 million voxels of grey and white matter.
assert 1_200_000 < grown < 1_700_000

truth_file = root / ".." / "shared" / "data" / "colin27_tissue_labels.nii.gz"
if truth_file.exists():
    truth = gzip.decompress(truth_file.read_bytes())[352:]
    is_brain = truth.translate(bytes(1 if v in (4, 5) else 0 for v in range(256)))
    both = (int.from_bytes(is_brain, "little") & int.from_bytes(labels, "little")).bit_count() \
        if hasattr(int, "bit_count") else sum(x & y for x, y in zip(is_brain, labels))
    dice = 2 * both / (grown + is_brain.count(1))
    print(f"Dice against the tissue labels: {dice:.3f}")
    # Strokes and a rewind alone; editing a region comes later.
    assert dice > 0.85
else:
    print(f"skipped: what it has in common with {truth_file}, which is not there")
