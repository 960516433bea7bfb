#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Files that were made to hurt: each gets the answer that its list says, at little cost.

usage: hostile.py VSTUDIO DATA_FOLDER     (DATA_FOLDER holds hostile/expected.tsv; exits 77 if it does not)

refuse: exit 1 and exactly one line on standard error, which names the entry; accept: exit 0; either: one of both. Each
within two seconds of processor time, all processes together, and half a gigabyte for each. Machines that are slower than usual
have as much more.
"""
import csv
import json
import os
import resource
import subprocess
import sys
import tempfile

from usual_machine import slowness

SECONDS = 2.0  # on a usual machine
MEGABYTES = 500
SANITIZED = "ASAN_OPTIONS" in os.environ or "TSAN_OPTIONS" in os.environ  # which cost many times as much


def command(program, path, out):
    name = os.path.basename(path)
    if name.startswith("journal_"):
        return [program, "recover", path, "-o", os.path.dirname(out)]
    return [program, "run", path, "-o", out] if name.startswith("session_") else [program, "info", path]


def run(arguments, folder):
    """Exit code, lines on standard error, seconds of processor time and the largest process in MB."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    try:
        done = subprocess.run(["/usr/bin/env", "python3", "-c", MEASURE, *arguments], capture_output=True, timeout=120,
                              env={**os.environ, "TMPDIR": folder})
    except subprocess.TimeoutExpired:
        return None, [], 120, 0
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    lines = done.stderr.decode(errors="replace").splitlines()
    largest = float(lines.pop()) if lines else 0
    seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return done.returncode, lines, seconds, largest, done.stdout.decode(errors="replace")


# Runs a command and says on the last line how large the largest of its processes was, in MB.
MEASURE = """
import resource, subprocess, sys
code = subprocess.run(sys.argv[1:]).returncode
print(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024, file=sys.stderr)
sys.exit(code if code >= 0 else 128 - code)
"""


def wrong(name, expected, program, path, folder, most):
    """What is wrong with the answer, or nothing."""
    code, lines, seconds, megabytes, *_ = run(command(program, path, os.path.join(folder, "out")), folder)
    errors = [line for line in lines if not line.startswith("note: ")]
    if code not in {"refuse": (1,), "accept": (0,), "either": (0, 1)}[expected]:
        return f"exit code {code} instead of {expected}: {' | '.join(lines)[:300]}"
    if code == 1 and (len(lines) != 1 or name not in lines[0]):
        return f"not one line that names it: {' | '.join(lines)[:300]}"
    if code == 0 and errors:
        return f"stray lines: {errors[0]}"
    if not SANITIZED and (seconds > most or megabytes > MEGABYTES):
        return f"cost {seconds:.1f} s of processor time and {megabytes:.0f} MB"
    return wrong_recovery(path, lines, folder) if name.startswith("journal_") else None


def wrong_recovery(path, lines, folder):
    """The session must hold the operations of all lines before the damaged one, which is told."""
    with open(path) as file:
        wanted = [json.loads(line)["operation"] for line in file.readlines()[1:-1]]
    session = next(name for name in os.listdir(folder) if name.endswith("-recovered.json"))
    with open(os.path.join(folder, session)) as file:
        found = json.load(file)["operations"]
    # Where an operation goes on, the journal repeats it; here none does.
    if [operation["op"] for operation in found] != [operation["op"] for operation in wanted]:
        return f"{len(found)} operations are recovered of {len(wanted)}"
    return None if any("left out" in line for line in lines) else "it is not said what was left out"


def export_on_full_disk(program, path, folder):
    """A disk that is full must leave the file that was there: the script says how that ends."""
    if os.geteuid() != 0 or subprocess.run(["sh", "-c", "d=$(mktemp -d) && mount -t tmpfs -o size=1m tmpfs $d && umount $d"],
                                           capture_output=True).returncode != 0:
        return "skipped"
    said = run(["sh", path, program], folder)[4].splitlines()[-1]
    return None if said == "exit 1, 16 bytes" else f"ended with \"{said}\""  # 16: "older good file"


def main():
    program, data = sys.argv[1:3]
    hostile = os.path.join(data, "hostile")
    table = os.path.join(hostile, "expected.tsv")
    if not os.path.exists(table):
        print("skipped: no test data at", hostile)
        return 77
    with open(table, newline="") as file:
        entries = [row[:2] for row in csv.reader(file, delimiter="\t") if row and not row[0].startswith("#")]
    failures, left = [], []
    with tempfile.TemporaryDirectory() as folder:
        most = SECONDS * slowness(program, folder)
        for name, expected in entries:
            path = os.path.join(hostile, name)
            is_script = name.endswith(".sh")
            answer = export_on_full_disk(program, path, folder) if is_script else wrong(name, expected, program, path, folder, most)
            if answer == "skipped":
                left.append(name)
            elif answer:
                failures.append(f"{name}: {answer}")
    for name in left:
        print("skipped:", name)
    print(f"{len(entries) - len(left)} entries, {len(failures)} wrong")
    for failure in failures:
        print("WRONG", failure)
    return 1 if failures or len(left) == len(entries) else 0


if __name__ == "__main__":
    sys.exit(main())
