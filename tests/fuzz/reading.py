#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Reads thousands of generated scans, whole and damaged ones, and looks at what came of each.

usage: reading.py FUZZ_READER VSTUDIO [--whole N] [--damaged N] [--seed S] [--keep FOLDER]

Whole ones, in all forms that a format allows, must be read as a second library reads them (nibabel, pydicom, VTK, unu), or be
refused. Damaged ones must be answered with values or one line, within two seconds of processor time and 500 MB; what is read
all the same must be what the second library reads, where it reads it. Every fiftieth is opened by the real program too.
With --keep the files of each failure are left there, and a line that makes them again is printed.
"""
import argparse
import json
import os
import random
import select
import shutil
import subprocess
import sys
import tempfile

import numpy

from mutations import mutated
from variants import FORMATS

HERE = os.path.dirname(os.path.abspath(__file__))
SECONDS = 2.0
MEGABYTES = 500
WAIT = 120  # for an answer at all
TYPES = {"uint8": "u1", "int8": "i1", "uint16": "u2", "int16": "i2", "uint32": "u4", "int32": "i4", "float32": "f4"}
SANITIZED = "ASAN_OPTIONS" in os.environ or "TSAN_OPTIONS" in os.environ  # which cost many times as much


class Server:
    """A process that answers lines with lines of JSON; begun anew when it has died."""

    def __init__(self, command):
        self.command = command
        self.process = None

    def ask(self, *words):
        if self.process is None:
            self.process = subprocess.Popen(self.command, stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                            stderr=subprocess.DEVNULL)
        try:
            self.process.stdin.write("\t".join(words).encode() + b"\n")
            self.process.stdin.flush()
        except BrokenPipeError:
            return self.end("died")
        if not select.select([self.process.stdout], [], [], WAIT)[0]:
            return self.end("hung")
        answer = self.process.stdout.readline()
        return json.loads(answer) if answer else self.end("died")

    def end(self, how):
        if self.process is not None:
            self.process.kill()
            code = self.process.wait()
            self.process = None
            return {how: code}
        return None


def places_differ(ours, theirs):
    """What the other library does not know is nan."""
    ours, theirs = numpy.array(ours, float).reshape(3, 4), numpy.array(theirs, float).reshape(3, 4)
    near = numpy.isclose(ours, theirs, rtol=1e-4, atol=2e-3 * max(1.0, numpy.abs(ours[:, :3]).max()))
    return not (near | numpy.isnan(theirs)).all()


def differing(ours, theirs):
    """Where values differ. What is not finite must be the same; floats were rounded to 32 bits, and what they cannot hold is
    infinite."""
    with numpy.errstate(all="ignore"):
        ours, theirs = ours.astype(numpy.float64), theirs.astype(numpy.float32).astype(numpy.float64)
        same = (ours == theirs) | (numpy.isnan(ours) & numpy.isnan(theirs))
        near = numpy.abs(ours - theirs) <= 1e-5 * numpy.maximum(numpy.abs(ours), numpy.abs(theirs)) + 1e-37
    return numpy.flatnonzero(~(same | near))


def difference(answer, second, files, compares_places):
    """What the two libraries read differently, or nothing. `files`: the values of both."""
    shape = list(second["shape"])
    if shape != answer["dims"][::-1]:
        return f"{answer['dims'][::-1]} voxels, the second library: {shape}"
    found = numpy.fromfile(files[0], TYPES[answer["type"]])
    expected = numpy.fromfile(files[1], "f8")
    wrong = differing(found, expected)
    if wrong.size:
        return (f"{wrong.size} values differ: {found[wrong[:4]]}, the second library: {expected[wrong[:4]]}; "
                f"{answer['notices']}")
    if compares_places and second["affine"] is not None and places_differ(answer["worldFromVoxel"], second["affine"]):
        return f"lies elsewhere: {answer['worldFromVoxel']}, the second library: {second['affine']}"
    return None


class Round:
    """One case: written, read by both, compared."""

    def __init__(self, servers, folder):
        self.reader, self.second = servers
        self.folder = folder

    def write(self, case):
        place = os.path.join(self.folder, "case")
        shutil.rmtree(place, ignore_errors=True)
        os.mkdir(place)
        for name, data in case.files.items():
            with open(os.path.join(place, name), "wb") as file:
                file.write(data)
        return os.path.join(place, case.main) if case.main else place

    def failure(self, case, whole):
        """What is wrong, or nothing; and what happened."""
        path = self.write(case)
        ours, theirs = (os.path.join(self.folder, name) for name in ("ours", "theirs"))
        answer = self.reader.ask(path, ours)
        if "died" in answer or "hung" in answer:
            return f"the reader {answer}", "failed"
        seconds, megabytes = answer["seconds"], answer["megabytes"]
        if not SANITIZED and megabytes > MEGABYTES:
            self.reader.end("too large")  # its figure would stay
            return f"took {megabytes:.0f} MB", "failed"
        if not SANITIZED and seconds > SECONDS:
            return f"took {seconds:.1f} s of processor time", "failed"
        if "refused" in answer:
            message = answer["refused"]
            if "\n" in message or not any(name in message for name in [os.path.basename(path), *case.files]):
                return f"not one line that names it: {message[:200]}", "failed"
            if "signal" in message:
                return f"the decoder crashed: {message}", "failed"
            return (None, "refused: " + message.split(": ", 1)[1][:70]) if whole else (None, "refused")
        second = self.second.ask(case.form, path, theirs)
        if "shape" not in second:
            return None, "read by us alone" + (f": {second['failed'][:60]}" if whole and "failed" in second else "")
        if any("skipped" in notice for notice in answer["notices"]):
            return None, "read without a damaged slice, which is said"
        if any("resampled" in notice for notice in answer["notices"]):
            return None, "resampled to a regular grid, which is said"
        failure = difference(answer, second, (ours, theirs), whole)
        if failure:
            return failure, "failed"
        return None, "the same"


def by_the_program(program, path):
    """The real program's answer: what is wrong with it, or nothing."""
    done = subprocess.run([program, "info", "--json", path], capture_output=True, timeout=WAIT)
    lines = [line for line in done.stderr.decode(errors="replace").splitlines() if not line.startswith("note: ")]
    if done.returncode not in (0, 1) or len(lines) != done.returncode:
        return f"vstudio info: exit code {done.returncode}, {lines[:3]}"
    return None


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("reader")
    parser.add_argument("program")
    parser.add_argument("--whole", type=int, default=1000)
    parser.add_argument("--damaged", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--first", type=int, default=0, help="the first case of each kind")
    parser.add_argument("--format", choices=FORMATS, help="only this one")
    parser.add_argument("--keep", help="a folder for the files of failures")
    options = parser.parse_args()
    servers = Server([options.reader]), Server([sys.executable, os.path.join(HERE, "second.py")])
    failures, counts = [], {}
    with tempfile.TemporaryDirectory() as folder:
        one = Round(servers, folder)
        for whole, count in ((True, options.whole), (False, options.damaged)):
            for n in range(options.first, options.first + count):
                source = random.Random(f"{options.seed} {whole} {n}")
                form = options.format or source.choice(list(FORMATS))
                case = FORMATS[form](source)
                if not whole:
                    case = mutated(source, case)
                failure, outcome = one.failure(case, whole)
                if not failure and n % 50 == 0:
                    failure = by_the_program(options.program, one.write(case))
                key = (form, "whole" if whole else "damaged", outcome)
                counts[key] = counts.get(key, 0) + 1
                if failure:
                    failures.append(failure)
                    again = f"--seed {options.seed} --first {n}" + (f" --format {options.format}" if options.format else "")
                    kind = "--whole 1 --damaged 0" if whole else "--whole 0 --damaged 1"
                    print(f"WRONG {form} {case.main or 'folder'} ({again} {kind}): {failure}", flush=True)
                    if options.keep:
                        shutil.copytree(os.path.join(folder, "case"),
                                        os.path.join(options.keep, f"{form}_{'whole' if whole else 'damaged'}_{n}"))
        for server in servers:
            server.end("done")
    for key, count in sorted(counts.items()):
        print(f"{count:6} {' '.join(key)}")
    print(f"{len(failures)} of {options.whole + options.damaged} wrong")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
