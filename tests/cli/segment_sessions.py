#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Replays the sessions of examples/segment with small pictures and checks what they segment: volumes against what anatomy and
intensities allow, overlap where a truth exists. Prints the rows of doc/segmentation_examples.md.
usage: segment_sessions.py VSTUDIO ROOT [NAME...]"""
import gzip
import json
import pathlib
import struct
import subprocess
import sys
import tempfile
import time

vstudio, root, names = sys.argv[1], pathlib.Path(sys.argv[2]), sys.argv[3:]
data = root / ".." / "shared" / "data"

# Of each label map: millilitres that a region must lie between, and why.
VOLUMES = {
    "brain/brain": (1500, 1800, "grey and white matter of this head are 1651 ml"),
    "ventricles/ventricles": (15, 35, "lateral ventricles of an adult, about 7 to 17 ml each"),
    "skull/skull": (570, 620, "a skull without its jaw; the head rest, as bright, would add 58 ml"),
    "tooth/molar": (0.6, 1.4, "one lower molar; without the cut of the laser its whole row, 4.0 ml"),
    "aneurysm/arteries": (85, 95, "what is at least 40 in one piece is 88600 to 91900 voxels of 1 mm3"),
    "malformation/sinuses": (27, 33, "the sinuses and the veins that join them; all vessels are 110 ml"),
    "malformation/nidus": (1.5, 2.5, "one piece of 6774 voxels that is brighter than 260, apart from the sinuses"),
    "stent/lumen": (80, 100, "the lumen and its branches in 200 to 450 are 92233 voxels in one piece"),
    "stent/stent": (11, 15, "of what is brighter than 600, without bone, 13 ml are wire"),
    "chest/thorax": (500, 700, "thorax without shoulder blades and arms; with them 783 ml of bone"),
    "colon/colon": (1300, 1800, "what the labels call colon are 1619 ml"),
    "pelvis/bones": (1300, 1800, "all labelled bones are 1576 ml"),
    "lungs/airways": (20, 45, "windpipe and main branches; 20 HU more and the lungs begin (479 ml)"),
    "lungs/lungs": (2200, 3000, "air of both lungs, one of them small above a high diaphragm"),
}
# Truths: file, its labels, what is asked of Dice.
TRUTHS = {
    "brain/brain": ("colin27_tissue_labels.nii.gz", {4, 5}, 0.95),
    "colon/colon": ("ct_torso_3mm_labels.nii.gz", {20}, 0.73),
    "pelvis/bones": ("ct_torso_3mm_labels.nii.gz", {*range(25, 34), 75, 76, 77, 78, *range(92, 116)}, 0.81),
}


def read_labels(path):
    """Voxels of a one-byte NIfTI file, and millilitres a voxel."""
    content = gzip.decompress(path.read_bytes())
    spacing = struct.unpack_from("<3f", content, 80)
    offset = int(struct.unpack_from("<f", content, 108)[0])
    return content[offset:], spacing[0] * spacing[1] * spacing[2] / 1000


def mask(labels, values):
    return labels.translate(bytes(1 if v in values else 0 for v in range(256)))


def dice(a, b):
    both = (int.from_bytes(a, "little") & int.from_bytes(b, "little")).bit_count()
    return 2 * both / (a.count(1) + b.count(1))


def replay(path, folder):
    """What the session writes, its report and seconds; None without its volume."""
    session = json.loads(path.read_text())
    volume = pathlib.Path(session["volume"]["path"])
    if not volume.is_absolute():
        volume = data / volume
    if not volume.exists():
        print(f"{path.stem}: skipped, {volume} is not there")
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
    strokes = sum(len(o.get("strokes", [])) + ("stroke" in o) + ("mask" in o and "stroke" not in o) + ("outline" in o)
                  for o in session["operations"])
    return folder / path.stem, strokes, seconds


checked = 0
with tempfile.TemporaryDirectory() as name:
    for path in sorted((root / "examples" / "segment").glob("*.json")):
        if names and path.stem not in names:
            continue
        done = replay(path, pathlib.Path(name))
        if not done:
            continue
        folder, strokes, seconds = done
        checked += 1
        pictures = [p.read_bytes() for p in folder.glob("*.png")]
        assert pictures and len(set(pictures)) == len(pictures), f"{path.name}: no two pictures are the same"
        for file in sorted(folder.glob("*.nii.gz")):
            key = f"{path.stem}/{file.name[:-7]}"
            labels, voxel_ml = read_labels(file)
            ml = (len(labels) - labels.count(0)) * voxel_ml
            least, most, reason = VOLUMES[key]
            row = f"{key}: {ml:.1f} ml, {strokes} strokes, {seconds:.1f} s"
            truth_file, values, least_dice = TRUTHS.get(key, (None, None, None))
            if truth_file and not (data / truth_file).exists():
                row += f", {truth_file} is not there"
            elif truth_file:
                truth, _ = read_labels(data / truth_file)
                overlap = dice(mask(labels, {1}), mask(truth, values))
                row += f", Dice {overlap:.3f}"
                assert overlap >= least_dice, (key, overlap)
            print(row)
            assert least <= ml <= most, f"{key}: {ml:.1f} ml, not {least} to {most}: {reason}"

if not checked:
    sys.exit(77)
