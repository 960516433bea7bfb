#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Replays the sessions of examples/segment with small pictures and checks what they segment: volumes against what anatomy and
intensities allow, overlap where a truth exists. Prints the rows of doc/segmentation_examples.md.
usage: segment_sessions.py VSTUDIO ROOT [NAME...]"""
import json
import pathlib
import subprocess
import sys
import tempfile
import time

from label_maps import dice, mask, read_labels

vstudio, root, names = sys.argv[1], pathlib.Path(sys.argv[2]), sys.argv[3:]
data = root / ".." / "shared" / "data"

# Of each segment: millilitres that it must lie between, and why.
VOLUMES = {
    "brain/grey and white matter": (1500, 1800, "the tissue labels give 1651 ml"),
    "matter/white matter": (600, 720, "the tissue labels give 661 ml"),
    "matter/grey matter": (900, 1080, "the tissue labels give 990 ml"),
    "ventricles/left lateral ventricle": (7, 17, "half of the 15 to 35 ml of an adult"),
    "ventricles/right lateral ventricle": (7, 17, "half of the 15 to 35 ml of an adult"),
    "skull/skull": (570, 620, "a skull without its jaw; the head rest, as bright, would add 58 ml"),
    "tooth/first lower molar": (0.6, 1.4, "one molar; without the cut of the laser its whole row, 4.0 ml"),
    "aneurysm/aneurysm": (10, 14, "a ball of 6 mm fits in nothing else; one of 28 mm across has 12 ml"),
    "aneurysm/arteries": (70, 80, "what is at least 40 in one piece is 89 ml, with the aneurysm"),
    "malformation/sinuses and veins": (50, 70, "most of the 110 ml of all vessels"),
    "malformation/nidus": (3, 7, "2 ml are brighter than 260, and three layers around them"),
    "malformation/other vessels": (18, 32, "the rest of the 110 ml of all vessels"),
    "stent/stent": (11, 15, "of what is brighter than 600, wire and not bone"),
    "stent/lumen": (85, 105, "in 200 to 450 alone it is 92 ml"),
    "stent/spine": (45, 60, "vertebrae in 200 to 2000 that are seen from one side"),
    "chest/spine, ribs and breastbone": (550, 650, "in one piece from 200 HU"),
    "chest/right shoulder": (100, 140, "a piece of its own from 200 HU"),
    "chest/left shoulder": (50, 75, "a piece of its own from 200 HU; the scan ends in it"),
    "lungs/airways": (20, 45, "windpipe and main branches; 20 HU more and the lungs begin (479 ml)"),
    "lungs/right lung": (700, 1000, "the small one, above a high diaphragm"),
    "lungs/left lung": (1500, 2000, "the large one"),
    "pelvis/spine": (300, 420, "as labelled 372 ml"),
    "pelvis/pelvis and femora": (1050, 1400, "as labelled 1155 ml"),
    "colon/colon": (1400, 1850, "the label has 1619 ml"),
}
# Truths: file, labels, and what is asked of Dice: a hundredth less than on the machine that the table was made on.
HEAD, TORSO = "colin27_tissue_labels.nii.gz", "ct_torso_3mm_labels.nii.gz"
TRUTHS = {
    "brain/grey and white matter": (HEAD, {4, 5}, 0.95),
    "matter/white matter": (HEAD, {5}, 0.89),
    "matter/grey matter": (HEAD, {4}, 0.84),
    "pelvis/spine": (TORSO, {*range(27, 34)}, 0.81),
    "pelvis/pelvis and femora": (TORSO, {25, 26, 75, 76, 77, 78}, 0.86),
    "colon/colon": (TORSO, {20}, 0.80),
}


def replay(path, folder):
    """What the session writes, its segments, strokes and seconds; None without its volume."""
    session = json.loads(path.read_text())
    volume = pathlib.Path(session["volume"]["path"])
    if volume.is_absolute() and not volume.exists():
        sys.exit(f"FAILED: {path.stem}: {volume} is not there (Debian package mricron-data)")
    volume = data / volume
    if not volume.exists():
        print(f"skipped: {path.stem}, {volume} is not there")
        return None
    for operation in session["operations"]:
        if operation["op"] == "picture":
            operation.update(size=[180, 140], samples=1)
    copy = folder / path.name
    copy.write_text(json.dumps(session))
    began = time.monotonic()
    result = subprocess.run([vstudio, "run", copy, "--volume", volume, "-o", folder / path.stem], capture_output=True, text=True)
    seconds = time.monotonic() - began
    assert result.returncode == 0, (path.name, result.stderr)
    report = json.loads((folder / path.stem / "report.json").read_text())
    assert report["complete"], path.name
    segments = list(dict.fromkeys(o.get("name", o["segment"]) for o in session["operations"] if o["op"] == "segment"))
    strokes = sum(len(o.get("strokes", [])) + ("stroke" in o) + ("mask" in o and "stroke" not in o) + ("outline" in o)
                  for o in session["operations"])
    return folder / path.stem, segments, strokes, seconds


def check(key, region, voxel_ml):
    ml = region.count(1) * voxel_ml
    row = f"  {key.split('/')[1]}: {ml:.1f} ml"
    truth_file, values, least_dice = TRUTHS.get(key, (None, None, None))
    overlap = None
    if truth_file and not (data / truth_file).exists():
        print(f"skipped: what {key} has in common with {truth_file}, which is not there")
    elif truth_file:
        overlap = dice(region, mask(read_labels(data / truth_file)[0], values))
        row += f", Dice {overlap:.3f}"
    print(row)
    least, most, reason = VOLUMES[key]
    assert least <= ml <= most, f"{key}: {ml:.1f} ml, not {least} to {most}: {reason}"
    assert overlap is None or overlap >= least_dice, f"{key}: Dice {overlap:.3f}, not {least_dice} or more"


checked = 0
with tempfile.TemporaryDirectory() as name:
    for path in sorted((root / "examples" / "segment").glob("*.json")):
        if names and path.stem not in names:
            continue
        done = replay(path, pathlib.Path(name))
        if not done:
            continue
        folder, segments, strokes, seconds = done
        checked += 1
        pictures = [p.read_bytes() for p in folder.glob("*.png")]
        assert pictures and len(set(pictures)) == len(pictures), f"{path.name}: no two pictures are the same"
        (file,) = folder.glob("*.nii.gz")
        labels, voxel_ml = read_labels(file)
        print(f"{path.stem}: {strokes} strokes, {seconds:.1f} s")
        for label, segment in enumerate(segments, 1):
            check(f"{path.stem}/{segment}", mask(labels, {label}), voxel_ml)
        assert set(labels) <= set(range(len(segments) + 1)), f"{path.stem}: no other labels"

if not checked:
    sys.exit(77)
