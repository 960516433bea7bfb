#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The values and places of what the program accepts among files that were made to hurt are those of a second library.

usage: corpus.py FUZZ_READER DATA_FOLDER     (DATA_FOLDER holds hostile/ and bad/; exits 77 if it does not)

What must be accepted must be read by the second library, too; what may be, and it cannot read, is printed, so that nothing
passes unseen.
"""
import csv
import os
import re
import shutil
import sys
import tempfile

import numpy

from reading import HERE, TYPES, Server, difference, differing

FORMS = {".nii": "nifti", ".nii.gz": "nifti", ".nrrd": "nrrd", ".nhdr": "nrrd", ".mha": "meta", ".mhd": "meta", ".vtk": "vtk",
         ".dcm": "dicom"}


def form_of(path):
    return next((form for end, form in FORMS.items() if path.endswith(end)), "dicom")


def scans(data):
    """Paths of all entries that are scans, and whether they must be accepted."""
    for folder in ("hostile", "bad"):
        with open(os.path.join(data, folder, "expected.tsv"), newline="") as file:
            for row in csv.reader(file, delimiter="\t"):
                if row and not row[0].startswith(("#", "session_", "journal_", "ply_")):
                    yield os.path.join(data, folder, row[0]), row[1] in ("accept", "notice")


def alone(path, folder):
    """A copy in a folder of its own, with the data file that a header names: what is beside it says nothing of it."""
    if os.path.isdir(path):
        return path
    place = os.path.join(folder, "alone")
    shutil.rmtree(place, ignore_errors=True)
    os.mkdir(place)
    with open(path, "rb") as file:
        named = re.search(rb"^(?:ElementDataFile *=|data ?file:) *(\S+)", file.read(4000), re.M)
    shutil.copy(path, place)
    beside = os.path.join(os.path.dirname(path), os.path.basename(named[1].decode("latin-1")) if named else "")
    if os.path.isfile(beside):
        shutil.copy(beside, place)
    return os.path.join(place, os.path.basename(path))


def ends_differ(answer, second, files):
    """Slices between uneven ones were computed, but the first and the last are there."""
    found = numpy.fromfile(files[0], TYPES[answer["type"]]).reshape(answer["dims"][::-1])
    expected = numpy.fromfile(files[1], "f8").reshape(second["shape"])
    ends = numpy.concatenate([differing(found[n], expected[n]) for n in (0, -1)])
    return (f"{ends.size} values of the first or last slice differ" if ends.size else "resampled, and the same at both ends",
            ends.size > 0)


def outcome(servers, path, must, folder):
    """What came of one of them, and whether that is wrong."""
    ours, theirs = (os.path.join(folder, name) for name in ("ours", "theirs"))
    path = alone(path, folder)
    answer = servers[0].ask(path, ours)
    if "dims" not in answer:
        return f"{answer}", must or "refused" not in answer
    second = servers[1].ask(form_of(path), path, theirs)
    if "resampled" in " ".join(answer["notices"]):
        return ends_differ(answer, second, (ours, theirs))
    if "shape" not in second:
        return f"read by us alone: {second}; {answer['notices']}", must
    wrong = difference(answer, second, (ours, theirs), True)
    return wrong or "the same", wrong is not None


def main():
    reader, data = sys.argv[1:3]
    if not os.path.exists(os.path.join(data, "hostile", "expected.tsv")):
        print("skipped: no test data at", data)
        return 77
    servers = Server([reader]), Server([sys.executable, os.path.join(HERE, "second.py")])
    failures, total = 0, 0
    with tempfile.TemporaryDirectory() as folder:
        for path, must in scans(data):
            said, is_wrong = outcome(servers, path, must, folder)
            failures += is_wrong
            total += 1
            print("WRONG" if is_wrong else "ok   ", os.path.basename(path), said[:300])
        for server in servers:
            server.end("done")
    print(f"{total} scans, {failures} wrong")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
