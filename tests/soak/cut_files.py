#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Files of all kinds, cut off at every 512 bytes: one line says so, or what is read is sound.

usage: cut_files.py FUZZ_READER VSTUDIO [--every BYTES] [--scans N] [--seed S]

Scans in all forms that tests/fuzz makes: refused in one line, or read with the values of the whole one, or with a notice that
says what is missing. Journals: the operations of all whole lines. Sessions, their states, label maps, transfer functions, pictures:
one line that names the file. Each within two seconds of processor time.
"""
import argparse
import json
import os
import pathlib
import random
import resource
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "fuzz"))

from reading import Server  # noqa: E402
from variants import FORMATS  # noqa: E402

SECONDS = 2.0
SANITIZED = "ASAN_OPTIONS" in os.environ or "TSAN_OPTIONS" in os.environ  # which cost many times as much


def cuts(size, every):
    """Lengths that a file of that size is cut to: the first bytes, every so many, all but one."""
    return sorted({0, 1, *range(every, size, every), size - 1} - {size})


class Cutter:
    def __init__(self, arguments, folder):
        self.vstudio = arguments.vstudio
        self.every = arguments.every
        self.folder = folder
        self.count = 0
        self.failures = []

    def say(self, what, found):
        self.count += 1
        if found:
            self.failures.append(f"{what}: {found}")
            print("WRONG", self.failures[-1], flush=True)

    def run(self, *words):
        """What came of a command, and the processor time that it took."""
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        done = subprocess.run([self.vstudio, *map(str, words)], capture_output=True, text=True, errors="replace", timeout=120)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        return done, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime

    def made(self, *words):
        done, _ = self.run(*words)
        assert done.returncode == 0, f"{words}: {done.stderr}"

    def refused(self, file, *words):
        """What is wrong with how a command refuses a file that was cut: it should be one line that names it."""
        done, seconds = self.run(*words)
        lines = [line for line in done.stderr.splitlines() if not line.startswith("note: ")]
        if done.returncode != 1 or len(lines) != 1 or file.name not in lines[0]:
            return f"exit code {done.returncode}, {lines}"
        return self.dear(seconds)

    def dear(self, seconds):
        return f"{seconds:.1f} s" if seconds > SECONDS and not SANITIZED else None

    def all_refused(self, file, *words, last_says_nothing=False):
        """A file that a command reads, cut everywhere. The whole one is read, and so is one without its last byte, where that says
        nothing: the end of a line, a checksum of nothing."""
        whole = file.read_bytes()
        self.made(*words)
        for length in cuts(len(whole), self.every):
            file.write_bytes(whole[:length])
            if length == len(whole) - 1 and last_says_nothing:
                self.made(*words)
                continue
            self.say(f"{file.name} cut to {length} of {len(whole)} bytes", self.refused(file, *words))
        file.write_bytes(whole)


# --- scans

def scan_fault(answer, values, whole, whole_values):
    if "refused" in answer:
        return f"is refused in several lines: {answer['refused']}" if "\n" in answer["refused"] else None
    if "dims" not in answer:
        return f"the reader {answer}"
    if answer["dims"] == whole.get("dims") and values == whole_values:
        return None
    return None if answer["notices"] else f"is read as {answer['dims']} without a notice"


def cut_scans(cutter, arguments):
    chance = random.Random(arguments.seed)
    server = Server([arguments.fuzz_reader])
    out = cutter.folder / "values"
    for number in range(arguments.scans):
        case = FORMATS[list(FORMATS)[number % len(FORMATS)]](chance)
        place = cutter.folder / "scan"
        shutil.rmtree(place, ignore_errors=True)
        place.mkdir()
        for name, data in case.files.items():
            (place / name).write_bytes(data)
        opened = place / case.main if case.main else place
        whole = server.ask(str(opened), str(out))
        if "dims" not in whole:
            continue  # which the fuzzer judges
        whole_values = out.read_bytes()
        for name, data in case.files.items():
            for length in cuts(len(data), cutter.every):
                (place / name).write_bytes(data[:length])
                answer = server.ask(str(opened), str(out))
                values = out.read_bytes() if "dims" in answer else None
                found = scan_fault(answer, values, whole, whole_values) or cutter.dear(answer.get("seconds", 0))
                cutter.say(f"{case.form} scan {number}, {name} cut to {length} of {len(data)} bytes", found)
            (place / name).write_bytes(data)
    server.end("done")


# --- what the program writes itself

OPERATIONS = [{"op": "peel", "layers": 4, "mask": {"shape": "ellipse", "points": [[500, 300], [700, 500]]}},
              {"op": "seed", "voxels": [[12, 14, 12]], "range": [60, 255]}, {"op": "grow", "generations": 4},
              {"op": "measure", "kind": "distance", "points": [[1, 1, 1], [9, 9, 9]]}] + [
              {"op": "note", "text": f"line {n}, which makes the file longer"} for n in range(30)]
VOLUME = {"phantom": "head", "dims": [24, 28, 24]}


def cut_sessions(cutter):
    first, session = cutter.folder / "first.json", cutter.folder / "session.json"
    first.write_text(json.dumps({"volumeStudioSession": 2, "volume": VOLUME, "operations": OPERATIONS}))
    cutter.made("run", first, "-o", cutter.folder, "--save", session)
    cutter.all_refused(session, "check", "--no-replay", session, last_says_nothing=True)
    cutter.all_refused(session.with_name("session.json.state"), "check", "--no-replay", session)


def cut_label_maps(cutter):
    scan = cutter.folder / "scan.nrrd"
    cutter.made("phantom", "head", "--size", "24x28x24", "-o", scan)
    for end in (".nrrd", ".nii", ".nii.gz", ".mha", ".mhd"):
        labels = cutter.folder / ("labels" + end)
        cutter.made("grow", scan, "--seed", "12,14,12", "--range", "60:255", "--steps", "6", "-o", labels)
        data = labels.with_suffix(".zraw") if end == ".mhd" else labels
        whole = data.read_bytes()
        for length in cuts(len(whole), cutter.every):
            data.write_bytes(whole[:length])
            done, seconds = cutter.run("stats", labels, "--volume", scan)
            lines = [line for line in done.stderr.splitlines() if not line.startswith("note: ")]
            named = done.returncode == 1 and len(lines) == 1 and (labels.name in lines[0] or data.name in lines[0])
            cutter.say(f"{data.name} cut to {length} of {len(whole)} bytes",
                       cutter.dear(seconds) if named else f"exit code {done.returncode}, {lines}")


def cut_functions_and_pictures(cutter):
    scan, picture, function = (cutter.folder / name for name in ("f.nrrd", "f.png", "f.json"))
    cutter.made("phantom", "head", "--size", "24x28x24", "-o", scan)
    points = [{"at": n * 5, "colour": "#8040ff", "opacity": 0.5} for n in range(40)]
    function.write_text(json.dumps({"volumeStudioTransferFunction": 1, "name": "cut", "kind": "intensity", "positions": "absolute",
                                    "points": points}))
    cutter.all_refused(function, "render", scan, "--mode", "volume", "--tf", function, "--size", "64x48", "-o", picture)
    other = cutter.folder / "other.png"
    shutil.copy(picture, other)
    cutter.all_refused(other, "compare", picture, other, last_says_nothing=True)


# --- journals: what was finished is there

def recovered(cutter, journal):
    """The operations that come back, or the line that says why none does."""
    target = cutter.folder / "recovered"
    shutil.rmtree(target, ignore_errors=True)
    target.mkdir()
    done, _ = cutter.run("recover", journal, "--keep", "-o", target)
    sessions = list(target.glob("*.json"))
    if done.returncode == 0 and len(sessions) == 1:
        return json.loads(sessions[0].read_text())["operations"], None
    lines = done.stderr.splitlines()
    return None, None if done.returncode == 1 and len(lines) == 1 and not sessions else f"exit code {done.returncode}, {lines}"


def cut_journals(cutter):
    journal = cutter.folder / "work.jsonl"
    lines = [{"volumeStudioJournal": 1, "volume": VOLUME, "precision": 16}]
    lines += [{"n": n, "operation": operation} for n, operation in enumerate(OPERATIONS)]
    whole = "".join(json.dumps(line) + "\n" for line in lines).encode()
    journal.write_bytes(whole)
    everything, fault = recovered(cutter, journal)
    assert everything and len(everything) == len(OPERATIONS), fault
    ends = [length for length in range(1, len(whole) + 1) if whole[length - 1:length] == b"\n"]
    for length in sorted({*cuts(len(whole), cutter.every), *ends[::7], *(end - 1 for end in ends[::7])}):
        journal.write_bytes(whole[:length])
        found, fault = recovered(cutter, journal)
        lines = whole[:length].count(b"\n")
        if lines > 0 and found != everything[:lines - 1]:
            fault = fault or f"{len(found or [])} operations come back of {lines - 1} whole lines"
        cutter.say(f"a journal cut to {length} of {len(whole)} bytes", fault)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("fuzz_reader")
    parser.add_argument("vstudio")
    parser.add_argument("--every", type=int, default=512, help="bytes")
    parser.add_argument("--scans", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        cutter = Cutter(arguments, pathlib.Path(name))
        parts = [("scans", lambda: cut_scans(cutter, arguments))]
        parts += [(part.__name__, lambda part=part: part(cutter))
                  for part in (cut_journals, cut_sessions, cut_label_maps, cut_functions_and_pictures)]
        for title, part in parts:
            before = cutter.count
            part()
            print(f"{title}: {cutter.count - before} cuts", flush=True)
    print(f"{cutter.count} cut files tried, {len(cutter.failures)} wrong")
    return 1 if cutter.failures else 0


if __name__ == "__main__":
    sys.exit(main())
