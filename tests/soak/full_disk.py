#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A disk that is full, or breaks, at every single call with which a command writes.

usage: full_disk.py VSTUDIO REFUSE_LIBRARY [--most N] [--only NAME]

For every command that writes files (those of tests/cli/writing.py, and a session with outputs of each kind), for the first call
that writes, the second, the third, and so on until the command succeeds: from that call on the disk is full, and once more only
that call fails by an error of the device. Each time either all is written as it should be, or the command ends with one line
that names the file and the reason, the older files are whole, and nothing lies beside them. With --most only so many of the
calls of each command are tried, spread evenly over them.
"""
import argparse
import errno
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "cli"))

from writing import OLDER, VSTUDIO, Inputs  # noqa: E402 (it takes the program from the same place)

OUTPUTS = ('{"volumeStudioSession": 1, "volume": {"path": "box.nrrd"}, "operations": ['
           '{"op": "seed", "voxels": [[6, 5, 4]], "range": [100, 255]}, {"op": "grow", "generations": 3}, '
           '{"op": "picture", "file": "p.png", "size": [64, 48], "samples": 1}, {"op": "labels", "file": "l.nrrd"}, '
           '{"op": "sculpture", "file": "c.nrrd"}, {"op": "movie", "file": "film", "size": [32, 24], "samples": 1, "rate": 10, '
           '"shots": [{"shot": "still", "seconds": 0.3, "orbit": "turntable"}]}]}')


class Refusal:
    """What becomes of calls: from the call on, by that error, once or from then on."""

    def __init__(self, call, error, once):
        self.call, self.error, self.once = call, error, once

    def __str__(self):
        return f"call {self.call}{' alone' if self.once else ' and all after it'}: {os.strerror(self.error)}"


def run(library, place, command, refusal, count_file):
    environment = {**os.environ, "LD_PRELOAD": library, "REFUSE_FOLDER": str(place), "REFUSE_COUNT": str(count_file)}
    if refusal:
        environment.update(REFUSE_FROM=str(refusal.call), REFUSE_ERROR=str(refusal.error))
        if refusal.once:
            environment["REFUSE_ONCE"] = "1"
    count_file.unlink(missing_ok=True)
    return subprocess.run([VSTUDIO, *map(str, command)], env=environment, capture_output=True, text=True, errors="replace",
                          timeout=300)


def contents(place):
    return {str(path.relative_to(place)): path.read_bytes() for path in sorted(place.rglob("*")) if path.is_file()}


def claims_success(report):
    """The report of a run is written again and again while it lasts: of one that failed it must not say that all is done."""
    return report != OLDER and json.loads(report)["complete"]


class Case:
    """A command with what its files are when nothing is refused."""

    def __init__(self, library, place, names, command, count_file):
        self.library, self.place, self.names, self.command, self.count_file = library, place, names, command, count_file
        self.good = self.rightly()
        self.calls = max(map(int, count_file.read_text().split()))  # of the program, not of those that it starts
        again = self.rightly()
        self.steady = {name for name, content in self.good.items() if again[name] == content}  # others hold times

    def rightly(self):
        done = self.do(None)
        assert done.returncode == 0, f"{self.names[0]}: {done.stderr}"
        found = contents(self.place)
        assert not [name for name, content in found.items() if content == OLDER], f"{self.names[0]}: is not written"
        return found

    def do(self, refusal):
        shutil.rmtree(self.place)
        self.place.mkdir()
        for name in self.names:
            (self.place / name).write_bytes(OLDER)
        return run(self.library, self.place, self.command(self.place / self.names[0]), refusal, self.count_file)

    def fault(self, refusal):
        """What is wrong with what became of it; nothing: all is well."""
        done = self.do(refusal)
        found = contents(self.place)
        lines = [line for line in done.stderr.splitlines() if not line.startswith("note: ")]
        if done.returncode == 0:
            return self.fault_of_success(done, found)
        if done.returncode != 1 or len(lines) != 1:
            return f"exit code {done.returncode}, {lines}"
        if not refusal.once and os.strerror(refusal.error) not in lines[0]:
            return f"the reason is not said: {lines[0]}"
        named = any(str(self.place / pathlib.Path(name).parts[0]) in lines[0] for name in (*self.good, *self.names))
        return self.fault_of_files(found) or (None if named else f"no file is named: {lines[0]}")

    def fault_of_success(self, done, found):
        """It says that all is well: then it is."""
        if "s.json" in self.good and found.get("s.json", OLDER) != OLDER and found.keys() - self.good.keys() <= {"s.json.state.new"}:
            return self.fault_of_session("without its state" in done.stderr)
        wrong = [name for name, content in self.good.items()
                 if name not in found or found[name] == OLDER or (name in self.steady and found[name] != content)]
        stray = [name for name in found if name not in self.good]
        return f"exit code 0, but wrong: {wrong}, left behind: {stray}" if wrong or stray else None

    def fault_of_session(self, tells):
        """A session may be saved without its state, of which is told; and its state is found under the name of a new one too."""
        opened = subprocess.run([VSTUDIO, "check", "--no-replay", self.place / "s.json"], capture_output=True, text=True)
        wanted = "no state" if tells else "whole and fits"
        return None if opened.returncode == 0 and wanted in opened.stdout else f"not '{wanted}': {opened.stdout}{opened.stderr}"

    def fault_of_files(self, found):
        """It says that it failed: what belongs together is as it was, and what does not is either old or new."""
        stray = [name for name in found if name not in self.good]
        gone = [name for name in self.names if name not in found]
        torn = [name for name in found if name in self.steady and found[name] not in (OLDER, self.good[name])]
        if claims_success(found.pop("report.json", OLDER)):
            torn.append("report.json")
        is_one = len(self.good) == len(self.names)  # else several files that have nothing to do with each other
        changed = [name for name in self.names if is_one and found.get(name, OLDER) != OLDER]
        if stray or gone or torn or changed:
            return f"left behind: {stray}, gone: {gone}, torn: {torn}, changed: {changed}"
        return None


def commands(inputs, folder):
    yield from inputs.commands()
    session = folder / "outputs.json"
    session.write_text(OUTPUTS)
    yield ("report.json", "p.png", "l.nrrd", "c.nrrd"), lambda out: ("run", session, "-o", out.parent)


def tried_calls(calls, most):
    """Numbers from 1 to the number of calls, all or so many of them, the first and the last among them."""
    if most is None or calls <= most:
        return range(1, calls + 1)
    return sorted({1 + round(n * (calls - 1) / (most - 1)) for n in range(most)})


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("vstudio")
    parser.add_argument("library")
    parser.add_argument("--most", type=int, help="calls of each command that are tried; without: all")
    parser.add_argument("--only", default="", help="commands whose first file has that in its name")
    arguments = parser.parse_args()
    library = os.path.abspath(arguments.library)
    failures, count, kinds = [], 0, 0
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        place = folder / "place"
        place.mkdir()
        for names, command in commands(Inputs(folder), folder):
            if arguments.only not in names[0]:
                continue
            kinds += 1
            case = Case(library, place, names, command, folder / "count")
            assert case.calls > 0, f"{names[0]}: no call was seen"
            for call in tried_calls(case.calls, arguments.most):
                for refusal in (Refusal(call, errno.ENOSPC, False), Refusal(call, errno.EIO, True)):
                    count += 1
                    if found := case.fault(refusal):
                        failures.append(f"{names[0]}, {refusal}: {found}")
                        print("WRONG", failures[-1], flush=True)
            print(f"{', '.join(names)}: {case.calls} calls", flush=True)
    print(f"{count} refusals in {kinds} commands tried, {len(failures)} wrong")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
