# SPDX-License-Identifier: Apache-2.0
"""Everything but the strokes themselves by keys alone: this test never touches the mouse."""

import argparse
import json
import sys

from driver import need, run_test, start
from phantom import write_ball_head
from replay import compare_with_replay, operations

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


def choose_by_arrows(studio):
    """Of choices Tab reaches the one that is chosen; arrow keys go on to the others."""
    tab_around(studio, "tabRange")
    press(studio, "Right", "the next page", lambda s: s["focus"] == "tabIntensity" and "intensityCurve" in s["widgets"])
    press(studio, "Left", "the page before", lambda s: s["focus"] == "tabRange" and "rangeLo" in s["widgets"])


def look_around(studio):
    tab_around(studio, "view")
    for key, moved in (("Right", "azimuth"), ("Up", "elevation"), ("ctrl+Right", "roll"), ("plus", "zoom"),
                       ("minus", "zoom"), ("shift+Left", "pan")):
        before = studio.state()["camera"][moved]
        press(studio, key, f"{key} to change {moved}", lambda s: s["camera"][moved] != before)
    press(studio, "Home", "the view from the front", lambda s: s["camera"]["azimuth"] == 0 == s["camera"]["roll"])
    press(studio, "Left", "the camera to turn", lambda s: s["camera"]["azimuth"] != 0)


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


def main(display, arguments, folder):
    volume = folder / "head.nrrd"
    write_ball_head(volume)
    write_session(folder / "begun.json", volume)
    studio = start(display, arguments.program, folder)
    studio.wait("the start screen", lambda s: "welcome" in s["widgets"])
    tab_around(studio, "openButton")
    studio.key("space")
    type_path(studio, "openDialog", folder / "begun.json")
    studio.wait_idle("the session", lambda s: s["voxels"] == 1)

    press(studio, "ctrl+w", "the start screen", lambda s: "recent0" in s["widgets"])
    tab_around(studio, "recent0")
    studio.key("Return")
    studio.wait_idle("the session again", lambda s: s["voxels"] == 1 and s["viewRect"])

    for key, tool in (("p", "peel"), ("d", "drill"), ("s", "seed"), ("v", "camera"), ("p", "peel")):
        press(studio, key, f"the {tool} tool", lambda s: s["tool"] == tool)
    press(studio, "2", "MIP", lambda s: s["mode"] == "mip")
    press(studio, "1", "the surface", lambda s: s["mode"] == "surface")
    reached = set(tab_around(studio))
    need(REACHED <= reached, f"Tab does not reach {REACHED - reached}, but {sorted(reached)}")
    choose_by_arrows(studio)
    look_around(studio)
    grow(studio)
    steps = studio.state()["stepsDone"]
    press(studio, "ctrl+z", "undo", lambda s: s["stepsDone"] == steps - 1)
    press(studio, "ctrl+shift+z", "redo", lambda s: s["stepsDone"] == steps)
    press(studio, "1", "the surface", lambda s: s["mode"] == "surface")

    studio.wait_idle()
    studio.key("F12")
    type_path(studio, "screenshotDialog", folder / "window.png")
    studio.wait_idle("the picture", lambda s: s["message"].startswith("Saved picture"))
    studio.key("ctrl+s")
    type_path(studio, "saveDialog", folder / "session.json")
    studio.wait_idle("the session", lambda s: "session.json" in s["message"])
    viewport = studio.state()["viewport"]
    studio.xdotool("key", "ctrl+q", ends=True)
    need(studio.process.wait(30) == 0, "the program did not end well")
    session = folder / "session.json"
    need({"seed", "grow", "rewind"} <= {operation["op"] for operation in operations(session)}, "the session lacks a step")
    compare_with_replay(arguments.vstudio, session, folder / "window.png", viewport, folder)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", required=True)
    parser.add_argument("--vstudio", required=True)
    parser.add_argument("--work", required=True, help="folder to work in; emptied first")
    sys.exit(run_test(main, parser.parse_args()))
