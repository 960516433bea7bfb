# SPDX-License-Identifier: Apache-2.0
"""A head to test on, the real one where it is installed, else one made of nested balls; and a label map of that one."""

import pathlib

REAL = pathlib.Path("/usr/share/mricron/templates/ch2.nii.gz")

SIDE = 72
SCALP, SKULL, BRAIN = 120, 20, 180


def write_ball_head(path):
    """Scalp, a dark skull and a bright brain around one centre, as NRRD with 2.5 mm voxels."""
    middle = (SIDE - 1) / 2
    squares = [(i - middle) ** 2 for i in range(SIDE)]
    values = bytearray(SIDE ** 3)
    at = 0
    for z in squares:
        for y in squares:
            for x in squares:
                r2 = x + y + z
                values[at] = BRAIN if r2 < 26 ** 2 else SKULL if r2 < 29 ** 2 else SCALP if r2 < 33 ** 2 else 0
                at += 1
    header = (f"NRRD0004\ntype: uint8\ndimension: 3\nspace: left-posterior-superior\nsizes: {SIDE} {SIDE} {SIDE}\n"
              "space directions: (2.5,0,0) (0,2.5,0) (0,0,2.5)\nspace origin: (0,0,0)\nencoding: raw\n\n")
    path.write_bytes(header.encode() + values)


def write_labels(path):
    """Two boxes deep in the head, named as 3D Slicer names them, on the grid of write_ball_head()."""
    values = bytearray(SIDE ** 3)
    for z in range(30, 40):
        for y in range(30, 40):
            for x in range(25, 45):
                values[(z * SIDE + y) * SIDE + x] = 3 if x < 35 else 9
    header = (f"NRRD0004\ntype: uint8\ndimension: 3\nspace: left-posterior-superior\nsizes: {SIDE} {SIDE} {SIDE}\n"
              "space directions: (2.5,0,0) (0,2.5,0) (0,0,2.5)\nspace origin: (0,0,0)\nencoding: raw\n"
              "Segment0_LabelValue:=9\nSegment0_Name:=Core\nSegment0_Color:=0.1 0.9 0.2\n\n")
    path.write_bytes(header.encode() + values)


def head(folder, is_generated):
    if REAL.exists() and not is_generated:
        return REAL
    path = folder / "head.nrrd"
    write_ball_head(path)
    return path
