#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs `vstudio info` on every entry of a folder of malformed files and compares with its expected.tsv.

usage: bad_inputs.py VSTUDIO DATA_FOLDER     (DATA_FOLDER holds bad/expected.tsv; exits 77 if it does not)

accept: exit 0; notice: exit 0 and a line "note: ..." on standard error; refuse: exit 1 and exactly one line there that
contains the entry's name, under five seconds; either: notice or refuse.
"""
import csv
import os
import subprocess
import sys
import time

SECONDS = 5.0


def run(program, arguments):
    start = time.monotonic()
    try:
        done = subprocess.run([program, "info", *arguments], capture_output=True, timeout=60)
    except subprocess.TimeoutExpired:
        return None, "", [], time.monotonic() - start
    lines = done.stderr.decode(errors="replace").splitlines()
    return done.returncode, done.stdout.decode(errors="replace"), lines, time.monotonic() - start


def answer(name, code, lines, seconds):
    """What the program did, or a complaint about how it did it."""
    if code is None:
        return "hung"
    if code == 0:
        if any(not line.startswith("note: ") for line in lines):
            return "stray line on standard error: " + next(l for l in lines if not l.startswith("note: "))
        return "notice" if lines else "accept"
    if code != 1:
        return f"exit code {code}"
    if len(lines) != 1:
        return f"{len(lines)} lines on standard error"
    if name not in lines[0]:
        return "the message does not name the entry"
    if seconds > SECONDS:
        return f"took {seconds:.1f} s"
    return "refuse"


def main():
    program, data = sys.argv[1:3]
    folder = os.path.join(data, "bad")
    table = os.path.join(folder, "expected.tsv")
    if not os.path.exists(table):
        print("skipped: no test data at", folder)
        return 77
    entries = []
    with open(table, newline="") as file:
        for row in csv.reader(file, delimiter="\t"):
            if row and not row[0].startswith("#"):
                entries.append((row[0], row[1], []))
    layout = ["--raw", "32x32x32:uint8"]
    for name in sorted(os.listdir(folder)):
        if name.endswith("_32x32x32_uint8.raw"):
            entries.append((name, "accept" if name.startswith("good") else "refuse", layout))
    allowed = {"accept": {"accept", "notice"}, "notice": {"notice"}, "refuse": {"refuse"},
               "either": {"notice", "refuse"}}
    counts, failures = {}, 0
    for name, expected, options in entries:
        code, _, lines, seconds = run(program, [os.path.join(folder, name), *options])
        got = answer(name, code, lines, seconds)
        ok = got in allowed[expected]
        counts[(expected, got)] = counts.get((expected, got), 0) + 1
        failures += not ok
        print("ok  " if ok else "FAIL", name, f"(expected {expected}, got {got}, {seconds:.2f} s)", *lines, sep="  ")
    for (expected, got), count in sorted(counts.items()):
        print(f"{expected} -> {got}: {count}")
    print(f"{len(entries)} entries, {failures} failures")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
