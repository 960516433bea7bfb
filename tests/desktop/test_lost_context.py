# SPDX-License-Identifier: Apache-2.0
"""The graphics driver is reset in the midst of a stroke: the program says so, starts again and brings back the rest."""

import json
import subprocess
import sys

from driver import need, start
from phantom import write_ball_head
from steps import Steps

test = Steps()


def journals(folder):
    return sorted((folder / "home" / "state" / "volume-studio" / "journals").glob("*.jsonl"))


def journalled(path):
    lines = [json.loads(line) for line in path.read_text().splitlines()]
    return [line["operation"] for line in lines if "operation" in line]


def cut(studio, begin, end):
    (x0, y0), (x1, y1) = studio.view_point(*begin), studio.view_point(*end)
    studio.drag([(x0 + (x1 - x0) * i // 5, y0 + (y1 - y0) * i // 5) for i in range(6)])


@test.step
def studio(display, arguments, folder):
    write_ball_head(folder / "head.nrrd")
    display.environment["LD_PRELOAD"] = arguments.loss
    display.environment["VS_LOSE_CONTEXT"] = str(folder / "lose")
    studio = start(display, arguments.program, folder, [folder / "head.nrrd"])
    studio.wait_idle("the volume", lambda s: s["pictureComplete"])
    studio.move(studio.view_point(0.5, 0.5))
    studio.key("x")
    studio.wait("the scissors", lambda s: s["tool"] == "scissors")
    studio.key("n")
    for begin, end in (((0.40, 0.30), (0.46, 0.40)), ((0.50, 0.30), (0.56, 0.40))):
        before = studio.state()["operations"]
        cut(studio, begin, end)
        studio.wait_idle("the cut", lambda s: s["operations"] > before and s["pictureComplete"])
    return studio


@test.step
def told(studio, folder):
    """The driver is reset while the third stroke is drawn; nothing of that one is kept."""
    done = journalled(journals(folder)[0])
    (x0, y0), (x1, y1) = studio.view_point(0.44, 0.5), studio.view_point(0.52, 0.6)
    studio.arrive((x0, y0))
    studio.xdotool("mousedown", 1, "mousemove", (x0 + x1) // 2, y0)
    (folder / "lose").touch()
    studio.send("mousemove", x1, y1, "mouseup", 1)
    studio.wait("the message", lambda s: "startAgain" in s["widgets"])
    need(journalled(journals(folder)[0]) == done, "the journal has what was done without a device")
    return done


@test.step
def again(studio, told):
    """Becomes the program anew, which offers what was done."""
    studio.send("key", "Return")
    studio.wait("the offer of the program anew", lambda s: "recover0" in s["widgets"] and "startAgain" not in s["widgets"])
    studio.fences = 0  # that it has answered
    need(studio.process.poll() is None, "the program has ended")
    studio.click("recover0")
    state = studio.wait_idle("the recovery", lambda s: s["operations"] == len(told) and s["pictureComplete"])
    need(state["unsaved"], "what was recovered counts as saved")


@test.step(after=[again])
def goes_on(studio, told):
    studio.move(studio.view_point(0.5, 0.5))
    studio.key("x")
    studio.wait("the scissors", lambda s: s["tool"] == "scissors")
    cut(studio, (0.44, 0.5), (0.52, 0.6))
    studio.wait_idle("the stroke", lambda s: s["operations"] > len(told) and s["pictureComplete"])


@test.step(after=[studio])
def command(arguments, display, folder):
    """The command line says it in a line, and writes nothing."""
    session = folder / "session.json"
    session.write_text(json.dumps({"volumeStudioSession": 1, "volume": {"path": str(folder / "head.nrrd")},
                                   "operations": [{"op": "note", "text": "here"}, {"op": "picture", "file": "a.png"}]}))
    sign = folder / "lose another"
    sign.touch()
    run = subprocess.run([arguments.vstudio, "run", session, "-o", folder / "out"], capture_output=True, text=True,
                         env={**display.environment, "VS_LOSE_CONTEXT": str(sign)})
    need(run.returncode != 0 and run.stderr.count("\n") == 1, f"status {run.returncode}: {run.stderr}")
    need("driver was reset" in run.stderr, run.stderr)
    need(not list((folder / "out").glob("*.png")), "a picture was written")


if __name__ == "__main__":
    sys.exit(test.main(__doc__, "--program", "--vstudio", "--loss"))
