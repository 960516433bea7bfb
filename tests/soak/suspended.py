# SPDX-License-Identifier: Apache-2.0
"""The window is stopped and goes on (SIGSTOP, SIGCONT: a laptop's lid, a terminal's Ctrl+Z) amid growth, a stroke and reading: nothing
is lost, and nothing is given up.

usage: suspended.py --program volume-studio --vstudio vstudio --work FOLDER [--seconds S]"""

import os
import pathlib
import signal
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "desktop"))

from driver import looks, need, start  # noqa: E402
from phantom import write_ball_head  # noqa: E402
from steps import Steps  # noqa: E402
from test_decoder import Decoder, processes_of  # noqa: E402
from test_recovery import cut, journalled, journals, seed  # noqa: E402

test = Steps()


def stopped(process):
    return pathlib.Path(f"/proc/{process}/stat").read_text().rsplit(")", 1)[1].split()[0] in "Tt"


def suspend(processes, seconds):
    """Stops them all, in that order, and lets them rest. Nothing is waited for: the rest is what is tried."""
    for process in processes:
        os.kill(process, signal.SIGSTOP)
    for _ in looks(10):
        if all(stopped(process) for process in processes):
            break
    for _ in looks(seconds):
        pass


def resume(processes):
    for process in processes:
        os.kill(process, signal.SIGCONT)


@test.step
def decoder(display, arguments, folder):
    return Decoder(display, arguments.program, folder)


@test.step
def studio(display, arguments, folder, decoder):
    for name in ("first.nrrd", "second.nrrd"):
        write_ball_head(folder / name)
    studio = start(display, arguments.program, folder, [folder / "first.nrrd"])
    studio.wait_idle("the volume", lambda s: s["pictureComplete"])
    return studio


@test.step
def reading(studio, arguments, folder, decoder):
    """Window and decoder are stopped together while a scan is read, and go on together: it is read."""
    begun, gate = folder / "begun", folder / "gate"
    decoder.does(f"touch {begun}; while [ ! -e {gate} ]; do sleep 0.01; done; exec {{decoder}}")
    studio.key("ctrl+o")
    studio.type_path("openDialog", folder / "second.nrrd")
    studio.wait("the decoder", lambda s: begun.exists())
    both = [studio.process.pid, *processes_of(studio.process.pid)]
    suspend(both, arguments.seconds)
    gate.touch()
    resume(reversed(both))  # whoever looks finds those at work that it waits for
    studio.wait_idle("the second scan", lambda s: s["title"].startswith("second") and s["pictureComplete"])


@test.step(after=[reading])
def in_a_stroke(studio, arguments, folder):
    """The pen goes on while the window is stopped: what it drew is there afterwards."""
    studio.move(studio.view_point(0.5, 0.5))
    studio.key("x")
    studio.wait("the scissors", lambda s: s["tool"] == "scissors")
    studio.key("n")
    cut(studio, (0.40, 0.30), (0.46, 0.40))
    studio.key("f")  # free-form: every place of the pen is a point of the outline
    before = studio.state()["operations"]
    way = [studio.view_point(0.5 + 0.01 * i, 0.3 + 0.02 * (i % 2)) for i in range(6)]
    studio.xdotool("mousemove", *way[0], "mousedown", 1, "mousemove", *way[1])
    suspend([studio.process.pid], arguments.seconds)
    studio.send(*[word for place in way[2:] for word in ("mousemove", *place)], "mouseup", 1)
    resume([studio.process.pid])
    studio.answer("the stroke")
    studio.wait_idle("the cut", lambda s: s["operations"] > before)
    (journal,) = journals(folder)
    drawn = journalled(journal)[-1]
    need(drawn["op"] == "scissors", f"the last operation is {drawn['op']}")
    need(len(drawn["outline"]["points"]) >= len(way) - 1, f"the outline has {drawn['outline']['points']}")


@test.step(after=[in_a_stroke])
def amid_growth(studio, arguments):
    """Growth goes on where it was."""
    seed(studio)
    before = studio.state()["generation"]
    studio.key("shift+g", lasting=True)
    studio.wait("growth", lambda s: s["generation"] > before or not s["playing"])
    suspend([studio.process.pid], arguments.seconds)
    resume([studio.process.pid])
    studio.key("ctrl+g", lasting=True)
    state = studio.wait_idle("the end of growth", lambda s: not s["playing"])
    need(state["generation"] >= before and state["segments"][0]["voxels"] > 1000, f"it has grown {state['segments']}")


@test.step(after=[amid_growth])
def ended(studio):
    need(studio.state()["glErrors"] == 0, "OpenGL errors")
    studio.quit()


def options(parser):
    parser.add_argument("--seconds", type=float, default=1.0, help="how long each rest is")


if __name__ == "__main__":
    sys.exit(test.main(__doc__, "--program", "--vstudio", configure=options))
