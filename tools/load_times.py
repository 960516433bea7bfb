#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""How long two builds of vstudio take to read files: `vstudio info`, interleaved, medians and their ratio.

usage: load_times.py VSTUDIO OTHER_VSTUDIO [--runs N] FILE...     (a ratio below 1: the first is faster)
"""
import argparse
import statistics
import subprocess
import time


def seconds(program, path):
    begin = time.perf_counter()
    subprocess.run([program, "info", path], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return time.perf_counter() - begin


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("other")
    parser.add_argument("files", nargs="+")
    parser.add_argument("--runs", type=int, default=11)
    options = parser.parse_args()
    for path in options.files:
        taken = {options.program: [], options.other: []}
        for run in range(options.runs + 1):
            for program, times in taken.items():
                once = seconds(program, path)
                if run > 0:  # the first fills the cache
                    times.append(once)
        first, second = (statistics.median(times) for times in taken.values())
        print(f"{path}: {first:.3f} s, {second:.3f} s, ratio {first / second:.2f}", flush=True)


if __name__ == "__main__":
    main()
