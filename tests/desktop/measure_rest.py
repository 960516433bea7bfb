# SPDX-License-Identifier: Apache-2.0
"""How long the window takes until a picture of 1230 x 870 is at full quality, and how much processor time: opens a session in the real
window, presses keys one after another ("4" is overlay mode, "shift+s" smooth sampling) and prints the seconds of each. No test: it
judges nothing."""

import os
import pathlib
import sys

from driver import start
from steps import Steps
from test_latency import fit_view, now_ms

test = Steps()


def processor_seconds(process):
    fields = pathlib.Path(f"/proc/{process.pid}/stat").read_text().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


@test.step
def measure(display, arguments, folder):
    studio = start(display, arguments.program, folder, [arguments.session])
    studio.wait_idle("the session", lambda s: s["pictureComplete"] and not s["playing"], 600)
    fit_view(studio)
    for keys in arguments.keys:
        begin, used = now_ms(), processor_seconds(studio.process)
        studio.key(keys)
        studio.wait_idle(keys, lambda s: s["pictureComplete"] and not s["playing"], 600)
        print(f"{keys:10} at rest after {(now_ms() - begin) / 1e3:6.2f} s; "
              f"{processor_seconds(studio.process) - used:6.2f} s of processor time", flush=True)


def with_session(parser):
    parser.add_argument("session")
    parser.add_argument("keys", nargs="+")


if __name__ == "__main__":
    sys.exit(test.main(__doc__, "--program", configure=with_session))
