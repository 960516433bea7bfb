#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Replays some of the experiments whose scans are made, with small pictures: the page, the table, what is true of their segments, and
what the strokes over pictures look like. usage: experiments.py VSTUDIO"""
import csv
import json
import pathlib
import re
import subprocess
import sys
import tempfile

vstudio = sys.argv[1]
# Least Dice of each segment: the issue's own where there is one, else a hundredth less than measured.
LEAST = {"left lateral ventricle": 0.95, "right lateral ventricle": 0.95, "arteries": 0.9, "lower left first molar": 0.92}


def call(*arguments):
    return subprocess.run([vstudio, *map(str, arguments)], capture_output=True, text=True)


def run(*arguments):
    result = call(*arguments)
    assert result.returncode == 0, result.stderr
    return result.stdout


def check_refusals(folder):
    unknown = call("experiments", "dentist", "-o", folder)
    assert unknown.returncode == 2 and "dentist" in unknown.stderr, unknown.stderr
    assert call("experiments", "arteries").returncode == 2, "no folder to write to"
    listed = run("experiments", "--list")
    for name in ("head", "exploded", "06_arteries_phantom", "ct_stent.nrrd"):
        assert name in listed, f"{name} is not listed"


def check_experiments(folder):
    names = ("02_ventricles_phantom", "arteries", "05_tooth_phantom")
    said = run("experiments", *names, "-o", folder, "--width", "240")
    assert "06_arteries_avm: skipped" in said, said
    page = (folder / "index.html").read_text()
    assert "http" not in page, "the page needs no network"
    pictures = re.findall(r'<img src="([^"]+)"', page)
    assert len(pictures) > 30 and len(set(pictures)) == len(pictures), f"{len(pictures)} pictures"
    contents = {(folder / picture).read_bytes() for picture in pictures}
    # One pair is: a region that was played backward looks as it did when it had grown so far.
    assert len(contents) == len(pictures) - 1, f"{len(contents)} of {len(pictures)} pictures differ"
    grown, rewound = (folder / "06_arteries_phantom" / f"{name}.png" for name in ("d_growing", "f_rewound"))
    assert grown.read_bytes() == rewound.read_bytes(), "backward is not exact"
    assert "cta_head_avm.nii.gz" in page, "what has no data is listed"
    rows = list(csv.DictReader((folder / "figures.csv").open()))
    assert [row["session"] for row in rows] == ["02_ventricles_phantom", "05_tooth_phantom", "06_arteries_phantom"]
    dice = {}
    for row in rows:
        assert float(row["surface_per_s"]) > 0 and float(row["load_s"]) > 0, row
        for part in row["dice"].split(", "):
            segment, value = part.rsplit(" ", 1)
            dice[segment] = float(value)
    assert float(rows[1]["laser_updates_per_s"]) > 0 and float(rows[2]["growth_voxels_per_s"]) > 0, rows
    print(dice)
    for segment, least in LEAST.items():
        assert dice[segment] >= least, f"{segment}: Dice {dice[segment]}, not {least} or more"


def check_strokes(folder):
    """Strokes to come are green, those that were are red, and a picture from elsewhere is refused them."""
    drill = {"op": "drill", "mask": {"shape": "circle", "points": [[615, 435], [675, 435]]}}

    def picture(name, **more):
        return {"op": "picture", "file": f"{name}.png", "size": [410, 290], "samples": 1, **more}

    def session(*operations):
        (folder / "strokes.json").write_text(json.dumps({
            "volumeStudioSession": 1, "volume": {"phantom": "head", "dims": [46, 55, 46]}, "operations": operations}))
        return call("run", folder / "strokes.json", "-o", folder)

    done = session(picture("plain"), picture("next", strokes="next"), drill, picture("cut"), picture("last", strokes="last"))
    assert done.returncode == 0, done.stderr
    for marked, plain in (("next", "plain"), ("last", "cut")):
        same = call("compare", folder / f"{marked}.png", folder / f"{plain}.png", "--mean", "0.05")
        assert same.returncode != 0, f"{marked} looks like {plain}"
    elsewhere = session(drill, {"op": "view", "camera": {"azimuth": 90}}, picture("elsewhere", strokes="last"))
    assert elsewhere.returncode == 1 and "camera" in elsewhere.stderr, elsewhere.stderr
    assert not (folder / "elsewhere.png").exists()


with tempfile.TemporaryDirectory() as name:
    check_refusals(pathlib.Path(name))
    check_strokes(pathlib.Path(name))
    check_experiments(pathlib.Path(name))
