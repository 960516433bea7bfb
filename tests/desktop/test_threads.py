# SPDX-License-Identifier: Apache-2.0
"""Runs the tests of what moves between threads in the window's model, on a display that nobody sees."""

import subprocess
import sys

from driver import need, own_home
from steps import Steps

test = Steps()


@test.step
def tests(display, arguments, folder):
    environment = dict(display.environment, **own_home(folder / "home"))
    done = subprocess.run([arguments.tests, str(folder)], env=environment, capture_output=True, text=True, timeout=600, check=False)
    print(done.stdout + done.stderr)
    need(done.returncode == 0, f"the tests ended with {done.returncode}")


if __name__ == "__main__":
    sys.exit(test.main(__doc__, "--tests"))
