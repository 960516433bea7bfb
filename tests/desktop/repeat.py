# SPDX-License-Identifier: Apache-2.0
"""Runs tests of the window again and again while busy loops take the processors, to find those that are lucky. Goes round all tests
that were asked for, one at a time, until each has run so often; what has run is kept in a table, so that it can be stopped and gone
on with. Prints a line for each run and a summary; fails when a run failed.

usage: repeat.py --build build/ci [--times 20] [--loops 2] [--table out/repeat.tsv] [TEST ...]
TEST: names as in ctest, for example desktop.histogram; all of the label desktop when none is given."""

import argparse
import collections
import json
import os
import pathlib
import subprocess
import sys
import time


def known_tests(build):
    listed = subprocess.run(["ctest", "--test-dir", build, "-L", "desktop", "--show-only=json-v1"],
                            check=True, capture_output=True, text=True)
    return [test["name"] for test in json.loads(listed.stdout)["tests"]]


def run(build, test, logs):
    """What came of one run: passed, skipped or failed; and its seconds."""
    began = time.monotonic()
    done = subprocess.run(["ctest", "--test-dir", build, "-R", f"^{test}$", "--output-on-failure", "--no-tests=error"],
                          check=False, capture_output=True, text=True)
    result = "failed" if done.returncode else "skipped" if "***Skipped" in done.stdout else "passed"
    if result == "failed":
        (logs / f"{test}.{int(time.time())}.log").write_text(done.stdout + done.stderr)
    return result, time.monotonic() - began


def read_table(path):
    counts = collections.defaultdict(collections.Counter)
    if path.exists():
        for line in path.read_text().splitlines():
            test, result, _ = line.split("\t")
            counts[test][result] += 1
    return counts


def main(arguments):
    tests = arguments.tests or known_tests(arguments.build)
    table = pathlib.Path(arguments.table)
    table.parent.mkdir(parents=True, exist_ok=True)
    counts = read_table(table)
    busy = f"while kill -0 {os.getpid()}; do :; done"  # no longer than this one lives, however it ends
    loops = [subprocess.Popen(["sh", "-c", busy], stderr=subprocess.DEVNULL) for _ in range(arguments.loops)]
    try:
        while due := [test for test in tests if sum(counts[test].values()) < arguments.times]:
            for test in due:
                result, seconds = run(arguments.build, test, table.parent)
                counts[test][result] += 1
                with table.open("a") as out:
                    out.write(f"{test}\t{result}\t{seconds:.0f}\n")
                print(f"{test} {sum(counts[test].values())}/{arguments.times}: {result}, {seconds:.0f} s", flush=True)
    finally:
        for loop in loops:
            loop.kill()
    for test in tests:
        print(f"{test}: {', '.join(f'{count} {result}' for result, count in sorted(counts[test].items()))}")
    return 1 if any(counts[test]["failed"] for test in tests) else 0


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", required=True, help="build folder")
    parser.add_argument("--times", type=int, default=20)
    parser.add_argument("--loops", type=int, default=2, help="busy loops beside the tests")
    parser.add_argument("--table", default="out/repeat.tsv", help="what has run already")
    parser.add_argument("tests", nargs="*", metavar="TEST")
    sys.exit(main(parser.parse_args()))
