# SPDX-License-Identifier: Apache-2.0
"""The history goes to any state by a click, and the picture is the same as when that state was first there. The
shortcut sheet is complete, and preferences count at once and are kept."""

import configparser
import json
import sys

from driver import need, start
from phantom import write_ball_head
from replay import compare_with_replay, run
from steps import Steps

test = Steps()


@test.step
def studio(display, arguments, folder):
    volume = folder / "head.nrrd"
    write_ball_head(volume)
    studio = start(display, arguments.program, folder, [volume])
    studio.wait_idle("the volume", lambda s: s["pictureComplete"])
    studio.move(studio.view_point(0.5, 0.5))
    return studio


def cut(studio, column):
    before = studio.state()["stepsDone"]
    x, y = studio.view_point(0.36 + 0.07 * column, 0.4)
    studio.drag([(x, y), (x + 12, y + 20), (x + 24, y + 40)])
    studio.wait_idle("the cut", lambda s: s["stepsDone"] == before + 1 and s["pictureComplete"])


def picture(studio, path):
    studio.move(studio.view_point(0.5, 0.9))
    studio.key("F12")
    studio.type_path("screenshotDialog", path)
    studio.wait_idle("the picture", lambda s: s["message"].startswith("Saved picture"))


def click_row(studio, row, rows):
    """Rows are equally high; the first one stands for the volume as it was opened."""
    x, y, width, _ = studio.state()["widgets"]["historyList"]
    height = studio.state()["historyRow"]
    need(0 <= row < rows, f"there is no row {row}")
    studio.click((x + width // 2, y + 2 + int((row + 0.5) * height)))


def go_to(studio, row, rows):
    click_row(studio, row, rows)
    return studio.wait_idle(f"the state after step {row}", lambda s: s["stepsDone"] == row and s["pictureComplete"])


@test.step
def cuts(studio, folder):
    """Four, with pictures after the second and the last."""
    studio.key("x")
    studio.wait("the scissors", lambda s: s["tool"] == "scissors")
    studio.key("n")
    for column in range(4):
        cut(studio, column)
        if column == 1:
            picture(studio, folder / "two.png")
    need("historyList" not in studio.state()["widgets"], "the history is shown before it was asked for")
    picture(studio, folder / "four.png")


@test.step(after=[cuts])
def travel(studio, folder):
    studio.key("ctrl+h")
    studio.wait_idle("the history", lambda s: "historyList" in s["widgets"] and s["historyRow"] > 0)

    rows = 5
    go_to(studio, 0, rows)
    state = go_to(studio, 2, rows)
    need(state["steps"] == 4 and state["canRedo"], "what could be redone is gone")
    go_to(studio, 4, rows)
    go_to(studio, 2, rows)
    studio.key("ctrl+h")
    studio.wait_idle("the history to go", lambda s: "historyList" not in s["widgets"] and s["pictureComplete"])
    picture(studio, folder / "again.png")


@test.step(after=[travel])
def same_picture(arguments, folder):
    print("state two again:", run(arguments.vstudio, "compare", folder / "two.png", folder / "again.png",
                                  "--mean", 0.01).strip())


NOTE = "two cuts are enough"


@test.step
def note(studio):
    """Writes a line into the history, which becomes a step of its own."""
    steps = studio.state()["stepsDone"]
    studio.key("ctrl+n")
    studio.wait("the question for a note", lambda s: "note" in s["windows"])
    studio.focus("note")
    studio.type(NOTE)
    studio.key("Return")
    studio.wait("the note", lambda s: "note" not in s["windows"] and s["stepsDone"] == steps + 1)
    studio.focus()


@test.step
def session(studio, folder):
    studio.key("ctrl+s")
    studio.type_path("saveDialog", folder / "session.json")
    studio.wait_idle("the session", lambda s: "session.json" in s["message"])
    return folder / "session.json"


@test.step(after=[note])
def note_of_session(session):
    operations = json.loads(session.read_text())["operations"]
    need({"op": "note", "text": NOTE} in operations, f"the session has no note '{NOTE}'")


@test.step
def shortcuts(studio):
    studio.key("F1")
    state = studio.wait("the shortcuts", lambda s: "shortcutSheet" in s["widgets"])
    for name in ("open", "startScreen", "undo", "peelTool", "seedTool", "mode.volume", "viewProbe", "shortcuts"):
        need(f"key_{name}" in state["widgets"], f"the shortcut sheet lacks {name}")
    studio.focus("shortcutSheet")
    studio.key("Escape")
    studio.wait("the shortcuts to close", lambda s: "shortcutSheet" not in s["widgets"])
    studio.focus()


@test.step
def preferences(studio, folder):
    studio.key("ctrl+comma")
    studio.wait("the preferences", lambda s: "themeLight" in s["widgets"])
    studio.click("themeLight")
    x, y, _, height = studio.state()["widgets"]["preferSmooth"]
    studio.move((x + 8, y + height // 2))  # the box itself: the rest of its row does nothing
    studio.xdotool("click", 1)
    studio.wait("the smooth picture", lambda s: s["smooth"])
    x, y, _, height = studio.state()["widgets"]["preferTint"]
    studio.move((x + 8, y + height // 2))
    studio.xdotool("click", 1)
    studio.wait("the tint of slices", lambda s: s["tintsSlices"])
    studio.choose("preferWindow", "Lung")
    studio.click("closePreferences")
    studio.wait("the preferences to close", lambda s: "preferencesDialog" not in s["widgets"])
    studio.focus()
    kept = configparser.ConfigParser()
    kept.read(folder / "home" / "config" / "volume-studio" / "volume-studio.ini")
    need(kept["General"]["slicewindow"] == "lung" and kept["General"]["tintslices"] == "true", "the window of slices is not kept")
    need(kept["General"]["theme"] == "light" and kept["General"]["smoothsampling"] == "true",
         f"the preferences are {dict(kept['General'])}")


@test.step
def viewport(studio):
    """Ends the program. Returns the size of its pictures."""
    state = studio.state()
    need(state["glErrors"] == 0, f"{state['glErrors']} OpenGL errors")
    studio.quit()
    return state["viewport"]


@test.step(after=[travel])
def replay(arguments, session, viewport, folder):
    compare_with_replay(arguments.vstudio, session, folder / "again.png", viewport, folder)


if __name__ == "__main__":
    sys.exit(test.main(__doc__, "--program", "--vstudio"))
