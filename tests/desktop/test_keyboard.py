# SPDX-License-Identifier: Apache-2.0
"""Everything but the strokes themselves by keys alone: this test never touches the mouse."""

import json
import sys

from driver import need, start
from phantom import write_ball_head
from replay import compare_with_replay, operations
from steps import Steps

test = Steps()

# Some of what Tab must reach: of the tool bar, each card, the view, the column of tools.
REACHED = {"open", "saveSession", "mode.mip", "tabRange", "rangeLo", "rangeHi", "peelRadius2", "autoStart",
           "rulesFold", "editFold", "numbersFold", "view", "cameraTool", "drillTool", "freeForm", "unCut"}


def write_session(path, volume):
    """What a pen has drawn: a seed in the brain. The rest is done by keys."""
    path.write_text(json.dumps({
        "volumeStudioSession": 1, "volume": {"path": volume.name},
        "operations": [{"op": "view", "range": [100, 200]},
                       {"op": "seed", "range": [150, 200], "voxels": [[36, 36, 36]]}]}))


def type_path(studio, dialog, path):
    """The field for the name has the keyboard when a dialog opens."""
    studio.wait(dialog, lambda s: dialog in s["widgets"] and s["focus"] == "fileNameEdit")
    studio.key("ctrl+a")
    studio.type(path)
    studio.key("Return")
    studio.wait(f"{dialog} to close", lambda s: dialog not in s["widgets"])
    studio.focus()


def press(studio, key, what, condition):
    studio.key(key)
    return studio.wait(what, condition)


def tab_around(studio, until=None, most=130):
    """Presses Tab until something has the keyboard, or has had it before; says what had it."""
    seen = []
    for _ in range(most):
        focus = studio.key("Tab")["focus"]
        if focus == until or (until is None and focus and focus in seen and len(seen) > 30):
            return seen + [focus]
        seen.append(focus)
    need(until is None, f"Tab never reached {until}, but {seen}")
    return seen


@test.step
def studio(display, arguments, folder):
    volume = folder / "head.nrrd"
    write_ball_head(volume)
    write_session(folder / "begun.json", volume)
    studio = start(display, arguments.program, folder)
    studio.wait("the start screen", lambda s: "welcome" in s["widgets"])
    return studio


@test.step
def open_session(studio, folder):
    tab_around(studio, "openButton")
    studio.key("space")
    type_path(studio, "openDialog", folder / "begun.json")
    studio.wait_idle("the session", lambda s: s["voxels"] == 1)


@test.step(after=[open_session])
def open_again(studio):
    press(studio, "ctrl+w", "the start screen", lambda s: "recent0" in s["widgets"])
    tab_around(studio, "recent0")
    studio.key("Return")
    studio.wait_idle("the session again", lambda s: s["voxels"] == 1 and s["viewRect"])


@test.step(after=[open_session])
def tools(studio):
    for key, tool in (("p", "peel"), ("d", "drill"), ("s", "seed"), ("v", "camera"), ("p", "peel")):
        press(studio, key, f"the {tool} tool", lambda s: s["tool"] == tool)


@test.step(after=[open_session])
def modes(studio):
    press(studio, "2", "MIP", lambda s: s["mode"] == "mip")
    press(studio, "1", "the surface", lambda s: s["mode"] == "surface")


@test.step(after=[tools])
def reach(studio):
    reached = set(tab_around(studio))
    need(REACHED <= reached, f"Tab does not reach {REACHED - reached}, but {sorted(reached)}")


@test.step(after=[open_session])
def choose_by_arrows(studio):
    """Of choices Tab reaches the one that is chosen; arrow keys go on to the others."""
    tab_around(studio, "tabRange")
    press(studio, "Right", "the next page", lambda s: s["focus"] == "tabIntensity" and "intensityCurve" in s["widgets"])
    press(studio, "Left", "the page before", lambda s: s["focus"] == "tabRange" and "rangeLo" in s["widgets"])


@test.step(after=[open_session])
def look_around(studio):
    tab_around(studio, "view")
    for key, moved in (("Right", "azimuth"), ("Up", "elevation"), ("ctrl+Right", "roll"), ("plus", "zoom"),
                       ("minus", "zoom"), ("shift+Left", "pan")):
        before = studio.state()["camera"][moved]
        press(studio, key, f"{key} to change {moved}", lambda s: s["camera"][moved] != before)
    press(studio, "Home", "the view from the front", lambda s: s["camera"]["azimuth"] == 0 == s["camera"]["roll"])
    press(studio, "Left", "the camera to turn", lambda s: s["camera"]["azimuth"] != 0)


@test.step(after=[open_session])
def grow(studio):
    press(studio, "period", "a step", lambda s: s["generation"] == 2)
    press(studio, "period", "another", lambda s: s["generation"] == 3)
    press(studio, "comma", "a step back", lambda s: s["generation"] == 2)
    studio.key("shift+g")
    studio.wait("the region to grow", lambda s: s["generation"] > 3 or not s["playing"])
    if studio.state()["playing"]:
        press(studio, "shift+g", "a pause", lambda s: not s["playing"])
    studio.key("ctrl+g")
    studio.wait_idle("the end of growth", lambda s: not s["playing"])


@test.step(after=[open_session])
def undo_and_redo(studio):
    steps = studio.state()["stepsDone"]
    press(studio, "ctrl+z", "undo", lambda s: s["stepsDone"] == steps - 1)
    press(studio, "ctrl+shift+z", "redo", lambda s: s["stepsDone"] == steps)
    press(studio, "1", "the surface", lambda s: s["mode"] == "surface")


@test.step(after=[open_session])
def session(studio, folder):
    """Saves a picture and the session, and ends. Returns the session's path and the picture's size."""
    studio.wait_idle()
    studio.key("F12")
    type_path(studio, "screenshotDialog", folder / "window.png")
    studio.wait_idle("the picture", lambda s: s["message"].startswith("Saved picture"))
    studio.key("ctrl+shift+s")  # in another file than it was opened from
    type_path(studio, "saveDialog", folder / "session.json")
    studio.wait_idle("the session", lambda s: "session.json" in s["message"])
    viewport = studio.state()["viewport"]
    studio.xdotool("key", "ctrl+q", ends=True)
    need(studio.process.wait(30) == 0, "the program did not end well")
    return folder / "session.json", viewport


@test.step
def operations_of_session(session):
    need({"seed", "grow", "rewind"} <= {operation["op"] for operation in operations(session[0])}, "the session lacks a step")


@test.step
def replay(arguments, session, folder):
    path, viewport = session
    compare_with_replay(arguments.vstudio, path, folder / "window.png", viewport, folder)


if __name__ == "__main__":
    sys.exit(test.main(__doc__, "--program", "--vstudio"))
