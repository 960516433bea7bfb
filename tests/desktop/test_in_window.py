# SPDX-License-Identifier: Apache-2.0
"""Runs the tests that live in the window's own process (tablet, fingers, names of widgets), and replays what they saved."""

import argparse
import json
import subprocess
import sys

from driver import need, own_home, run_test
from phantom import write_ball_head
from replay import compare_with_replay, operations


def main(display, arguments, folder):
    volume = folder / "head.nrrd"
    write_ball_head(volume)
    environment = dict(display.environment, QT_SCALE_FACTOR="1", **own_home(folder / "home"))
    codes = {}
    for language, tests in (("en", "*"), ("de", "Texts.*")):
        results = folder / language
        results.mkdir()
        command = [arguments.tests, str(volume), str(results), language, f"--gtest_filter={arguments.filter or tests}"]
        done = subprocess.run(command, env=environment, capture_output=True, text=True, timeout=1200, check=False)
        print(done.stdout + done.stderr)
        codes[language] = done.returncode
    need(not any(codes.values()), f"the tests in the window ended with {codes}")
    folder = folder / "en"
    session = folder / "tablet.json"
    if not session.exists():
        return
    drawn = {operation["op"] for operation in operations(session)}
    need({"drill", "laser", "peel", "seed"} <= drawn, f"the session holds only {drawn}")
    viewport = json.loads(session.read_text())["operations"]
    size = next(operation["canvas"]["viewport"] for operation in viewport if operation["op"] == "drill")
    compare_with_replay(arguments.vstudio, session, folder / "tablet.png", size, folder)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--tests", required=True)
    parser.add_argument("--filter", help="of GoogleTest")
    parser.add_argument("--vstudio", required=True)
    parser.add_argument("--work", required=True, help="folder to work in; emptied first")
    sys.exit(run_test(main, parser.parse_args()))
