# SPDX-License-Identifier: Apache-2.0
"""A session is played before one's eyes: it pauses and goes on, goes to steps and back, ends as its replay does, and an edit by hand ends
it. A case of the start screen is played by a click."""

import json
import sys

from driver import need, start
from phantom import write_ball_head
from replay import compare_with_replay
from steps import Steps

test = Steps()

OPERATIONS = [
    {"op": "view", "range": [80, 255], "camera": {"azimuth": 20, "elevation": 15}},
    {"op": "note", "text": "(a) A region on top is peeled."},
    {"op": "peel", "layers": 16, "mask": {"shape": "ellipse", "points": [[480, 150], [760, 380]]}},
    {"op": "note", "text": "(b) The laser follows."},
    {"op": "laser", "mask": {"shape": "circle", "points": [[615, 435], [640, 435]]},
     "stroke": [[560, 480, 0.4], [600, 500, 0.7], [650, 500, 1], [700, 480, 0.5]]},
    {"op": "picture", "file": "b.png"},
    {"op": "note", "text": "(c) The brain is seeded, and grows."},
    {"op": "view", "range": [150, 255]},
    {"op": "segment", "segment": "brain", "colour": [0.9, 0.5, 0.4]},
    {"op": "seed", "width": 9, "strokes": [{"shape": "free-form", "points": [[560, 260], [620, 280], [680, 260]]}]},
    {"op": "view", "mode": "segment", "range": [80, 255], "camera": {"azimuth": -30, "elevation": 30}},
    {"op": "grow", "generations": 30},
    {"op": "note", "text": "(d) Some of it is taken back, and it is pulled out."},
    {"op": "rewind", "generations": 12},
    {"op": "pull out", "segment": "brain", "move": [140, 0, 0]},
    {"op": "view", "camera": {"azimuth": 10, "elevation": 20, "zoom": 0.7, "pan": [40, 0]}},
]
EDITS = sum(operation["op"] not in ("view", "picture") for operation in OPERATIONS)


@test.step
def studio(display, arguments, folder):
    write_ball_head(folder / "head.nrrd")
    (folder / "played.json").write_text(json.dumps(
        {"volumeStudioSession": 1, "volume": {"path": "head.nrrd"}, "operations": OPERATIONS}))
    studio = start(display, arguments.program, folder, [])
    studio.resize(1230, 870)
    return studio


def ended(state):
    """All is done: there is nothing left to play."""
    return state["tool"] == "play" and state["stepsDone"] == EDITS and state["pictureComplete"]


@test.step
def from_file(studio, folder):
    """It plays as soon as it is open; Space holds it before it is at its end, and one step at a time goes on."""
    studio.key("ctrl+alt+o")
    studio.type_path("playDialog", folder / "played.json")
    studio.wait("playing", lambda s: s["tool"] == "play" and s["stepsDone"] > 0)
    studio.key("space")
    held = studio.wait_idle("the pause", lambda s: s["tool"] == "play")
    need(held["stepsDone"] < EDITS and not held["unsaved"], f"{held['stepsDone']} steps are done, unsaved: {held['unsaved']}")
    need("playStrip" in held["widgets"] and "playStep3" in held["widgets"], "the strip has a button for each step")


@test.step(after=[from_file])
def to_steps(studio):
    """Forward without playing what lies between, back by undo, and forward by one step."""
    studio.click("playStep4")  # (d): the first is what stands before all notes
    there = studio.wait_idle("step (d)", lambda s: s["stepsDone"] == EDITS - 3 and s["pictureComplete"])
    need(there["mode"] == "segment" and there["generation"] == 31, f"{there['mode']}, generation {there['generation']}")
    studio.click("playStep2")
    back = studio.wait_idle("step (b)", lambda s: s["stepsDone"] == 2 and s["pictureComplete"])
    need(back["mode"] == "surface" and back["voxels"] == 0 and not back["unsaved"], f"{back['mode']}, {back['voxels']} voxels")
    studio.click("playStep")
    studio.wait_idle("the laser", lambda s: s["stepsDone"] == 4 and s["pictureComplete"])
    studio.click("playBack")
    studio.wait_idle("before it again", lambda s: s["stepsDone"] == 2 and s["pictureComplete"])


@test.step(after=[to_steps])
def to_the_end(studio, arguments, folder):
    """Played to its end it is what its replay is, to a picture's pixels, and nobody need save it."""
    studio.click("playSession")
    end = studio.wait_idle("the end", ended)
    need(not end["unsaved"], "what was played is said to be unsaved")
    studio.key("F12")
    studio.type_path("screenshotDialog", folder / "window.png")
    state = studio.wait_idle("the picture", lambda s: s["message"].startswith("Saved picture"))
    need(state["glErrors"] == 0, f"{state['glErrors']} OpenGL errors")
    compare_with_replay(arguments.vstudio, folder / "played.json", folder / "window.png", state["viewport"], folder)


@test.step(after=[to_the_end])
def by_hand(studio):
    """A tool can be taken at any time, and what it does ends the playing."""
    studio.key("x")
    taken = studio.wait("the scissors", lambda s: s["tool"] == "scissors")
    need("playStrip" in taken["widgets"], "taking a tool ends nothing")
    studio.key("n")
    studio.drag([studio.view_point(0.3, 0.3), studio.view_point(0.35, 0.4), studio.view_point(0.4, 0.35)])
    cut = studio.wait_idle("the cut", lambda s: s["unsaved"] and s["pictureComplete"])
    need("playStrip" not in cut["widgets"], "it is still offered to be played")
    studio.key("ctrl+w")
    studio.wait("the question", lambda s: "discardEdits" in s["widgets"])
    studio.click("discardEdits")
    studio.wait("the start screen", lambda s: "welcome" in s["widgets"])


@test.step(after=[by_hand])
def a_case(studio):
    """A click on the start screen makes the scan and plays; going on by hand leaves what was done."""
    studio.click("case5")
    studio.wait("playing", lambda s: s["tool"] == "play" and s["stepsDone"] > 0, seconds=180)
    studio.click("goOnByHand")
    state = studio.wait_idle("the hand", lambda s: s["tool"] == "camera" and s["pictureComplete"])
    need("playStrip" not in state["widgets"] and state["title"].startswith("vessels"), state["title"])
    studio.quit()


if __name__ == "__main__":
    sys.exit(test.main(__doc__, "--program", "--vstudio"))
