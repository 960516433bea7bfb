# SPDX-License-Identifier: Apache-2.0
"""Runs the tests that live in the window's own process (tablet, fingers, names of widgets), and replays what they saved."""

import json
import subprocess
import sys

from driver import need, own_home
from phantom import write_ball_head
from replay import compare_with_replay, operations
from steps import Steps

test = Steps()


@test.step
def volume(folder):
    write_ball_head(folder / "head.nrrd")
    return folder / "head.nrrd"


def run_tests(display, arguments, folder, volume, language, tests):
    """Returns where they left what they saved."""
    results = folder / language
    results.mkdir()
    environment = dict(display.environment, QT_SCALE_FACTOR="1", **own_home(folder / "home"))
    command = [arguments.tests, str(volume), str(results), language, f"--gtest_filter={arguments.filter or tests}"]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, timeout=1200, check=False)
    print(done.stdout + done.stderr)
    need(done.returncode == 0, f"the tests in the window ended with {done.returncode} in the language {language}")
    return results


@test.step
def english(display, arguments, folder, volume):
    return run_tests(display, arguments, folder, volume, "en", "*")


@test.step
def german(display, arguments, folder, volume):
    run_tests(display, arguments, folder, volume, "de", "Texts.*:Actions.*")


@test.step
def session(english, arguments):
    """What was drawn with the tablet; nothing when a filter left that test out."""
    path = english / "tablet.json"
    if not path.exists() and arguments.filter:
        return None
    drawn = {operation["op"] for operation in operations(path)}
    need({"drill", "laser", "peel", "seed"} <= drawn, f"the session holds only {drawn}")
    return path


@test.step
def replay(arguments, english, session):
    if session is None:
        return
    drilled = json.loads(session.read_text())["operations"]
    size = next(operation["canvas"]["viewport"] for operation in drilled if operation["op"] == "drill")
    compare_with_replay(arguments.vstudio, session, english / "tablet.png", size, english)


def with_filter(parser):
    parser.add_argument("--filter", help="of GoogleTest")


if __name__ == "__main__":
    sys.exit(test.main(__doc__, "--tests", "--vstudio", configure=with_filter))
