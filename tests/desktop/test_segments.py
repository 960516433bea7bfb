# SPDX-License-Identifier: Apache-2.0
"""The segments of the window: the list, rules, scrubbing, absorbing, edits, brushes, label maps; all of it replayed."""

import sys

from driver import need, start
from phantom import write_ball_head, write_labels
from replay import compare_with_replay, operations, run
from steps import Steps

test = Steps()

ROW = 26  # logical pixels of a row of the list


def choose(studio, key, tool):
    studio.move(studio.view_point(0.5, 0.9))
    studio.key(key)
    studio.wait(f"the tool {tool}", lambda s: s["tool"] == tool)


def working(state):
    return next(segment for segment in state["segments"] if segment["working"])


def reveal(studio, widget):
    """Scrolls the panel until a widget is in sight."""
    for _ in range(60):
        _, y, _, height = studio.place_of(widget)
        widgets = studio.state()["widgets"]
        _, top, _, whole = widgets["panels"]
        if top <= y and y + height <= top + whole:
            return
        # Over the cards' left border nothing else takes the wheel.
        studio.move((widgets["panels"][0] + 4, top + whole // 2))
        studio.xdotool("click", 4 if y < top else 5)
    need(False, f"{widget} cannot be scrolled to")


def press(studio, widget, lasting=False):
    reveal(studio, widget)
    studio.click(widget, lasting=lasting)


def cell(studio, row, column):
    """A place in the list: colour, name, volume, eye, lock."""
    reveal(studio, "segments")
    x, y, width, _ = studio.state()["widgets"]["segments"]
    right = {"volume": 92, "eye": 43, "lock": 15}
    along = {"colour": 14, "name": 60}.get(column) or width - right[column]
    return x + along, y + 1 + row * ROW + ROW // 2


def click_cell(studio, row, column, times=1):
    studio.click(lambda: cell(studio, row, column), times=times)


def pace(studio, speed):
    """Generations per second, 0 for as many as it can: at one, growth can be paused on any machine before it ends."""
    reveal(studio, "growthSpeed")
    studio.type_number("growthSpeed", speed)


@test.step
def studio(display, arguments, folder):
    volume = folder / "head.nrrd"
    write_ball_head(volume)
    studio = start(display, arguments.program, folder, [volume])
    studio.resize(1230, 870)
    studio.wait_idle("the volume", lambda s: s["pictureComplete"])
    # The scalp's surface a little inside of where a segment's is: of two in the same place it is rounding that chooses.
    studio.type_number("rangeLo", 71)
    studio.wait_idle("the range", lambda s: s["range"][0] == 71)
    return studio


@test.step
def grow(studio):
    choose(studio, "s", "seed")
    studio.drag([studio.view_point(0.46 + 0.01 * i, 0.4) for i in range(9)])
    studio.wait_idle("growth to stop at a quarter", lambda s: s["stepsDone"] >= 2 and not s["playing"])
    reveal(studio, "growGoOn")
    studio.click("growGoOn")
    state = studio.wait_idle("growth", lambda s: s["message"].startswith("Grow:") and not s["playing"])
    need(state["mode"] == "segment" and state["extent"] > 10, f"nothing grew: {state['extent']} generations")
    return state


@test.step(after=[grow])
def scrub(studio):
    """The picture follows the bar while it is dragged; letting go leaves one operation."""
    before = studio.state()
    reveal(studio, "scrubBar")
    x, y, width, height = studio.state()["widgets"]["scrubBar"]
    studio.move((x + int(0.97 * width), y + height // 2))
    studio.xdotool("mousedown", 1)
    for place in (0.8, 0.6, 0.4):
        shown = studio.state()["generation"]
        studio.move((x + int(width * place), y + height // 2))
        studio.wait("the region to follow the bar", lambda s: s["generation"] < shown)
    studio.xdotool("mouseup", 1)
    state = studio.wait_idle("the end of scrubbing", lambda s: s["message"].startswith("Show generation"))
    need(0 < state["voxels"] < before["voxels"], "scrubbing back left as many voxels")
    # The view's change to segment mode is logged before it.
    need(state["operations"] - before["operations"] <= 2, "scrubbing left more than one operation")
    studio.key("ctrl+z")
    studio.wait_idle("undo", lambda s: s["voxels"] == before["voxels"])

    pace(studio, 1)
    press(studio, "growBackward")
    studio.wait("playing backward", lambda s: s["generation"] < before["generation"])
    press(studio, "growPause")
    studio.wait_idle("the pause", lambda s: not s["playing"])
    pace(studio, 0)
    press(studio, "growEnd")
    state = studio.wait_idle("all of it again", lambda s: not s["playing"] and s["voxels"] == before["voxels"])


@test.step(after=[grow])
def look_at_list(studio):
    """Names, eye, lock and opacity are operations that leave work where it is."""
    press(studio, "segmentAdd")
    state = studio.wait_idle("a second segment", lambda s: len(s["segments"]) == 2)
    need(working(state)["name"] == "Segment 2", f"the new segment is not at work: {state['segments']}")
    click_cell(studio, 0, "eye")
    studio.wait_idle("hidden", lambda s: not s["segments"][0]["visible"] and s["segments"][1]["working"])
    click_cell(studio, 0, "eye")
    studio.wait_idle("shown", lambda s: s["segments"][0]["visible"])
    click_cell(studio, 0, "lock")
    studio.wait_idle("locked", lambda s: s["segments"][0]["locked"])
    studio.key("ctrl+z")
    studio.wait_idle("unlocked by undo", lambda s: not s["segments"][0]["locked"])
    click_cell(studio, 0, "name", 2)
    studio.key("ctrl+a")
    studio.type("Scalp")
    studio.key("Return")
    state = studio.wait_idle("the name", lambda s: s["segments"][0]["name"] == "Scalp")
    need(working(state)["name"] == "Scalp", "a click on the name did not go to work on the segment")

    before = studio.state()["operations"]
    reveal(studio, "segmentOpacity")
    x, y, width, height = studio.state()["widgets"]["segmentOpacity"]
    studio.drag([(x + int(width * (0.94 - 0.05 * i)), y + height // 2) for i in range(10)])
    state = studio.wait_idle("the opacity", lambda s: s["segments"][0]["opacity"] < 0.9)
    need(state["operations"] - before <= 2, f"dragging the opacity left {state['operations'] - before} operations")
    studio.key("ctrl+z")
    studio.wait_idle("opaque again", lambda s: s["segments"][0]["opacity"] == 1)

    # By keyboard: down to the other, and up again.
    press(studio, "segments")
    studio.key("Down")
    studio.wait_idle("the other at work", lambda s: s["segments"][1]["working"])
    studio.key("Up")
    studio.wait_idle("the first at work", lambda s: s["segments"][0]["working"])


@test.step(after=[grow])
def change_rules(studio):
    """In live mode a tighter range takes away while it is dragged; the drag is one operation and one undo step."""
    before = studio.state()
    press(studio, "rulesFold")
    press(studio, "rulesLive")
    studio.wait_idle("live mode", lambda s: s["message"].startswith("Growth rules"))
    reveal(studio, "growthHistogram")
    x, y, width, height = studio.state()["widgets"]["growthHistogram"]
    operations_before = studio.state()["operations"]
    # The lower handle lies where the range begins; it is dragged to the right, past the scalp's value.
    lo = studio.state()["range"][0]
    handle = x + 6 + (width - 12) * lo / 180
    studio.drag([(int(handle + i * (0.76 * width - (handle - x)) / 12), y + height // 2) for i in range(13)], pause=0.05)
    state = studio.wait_idle("the tighter range", lambda s: s["voxels"] < before["voxels"])
    need(state["operations"] - operations_before <= 2,
         f"dragging a threshold left {state['operations'] - operations_before} operations")
    studio.key("ctrl+z")
    studio.wait_idle("the wide range", lambda s: s["voxels"] == before["voxels"])
    press(studio, "rulesFold")


@test.step(after=[grow])
def absorb(studio):
    choose(studio, "s", "seed")
    studio.key("r")
    studio.wait("the reversed sign", lambda s: "absorbed" in s["hint"])
    before = studio.state()["voxels"]
    pace(studio, 1)
    studio.drag([studio.view_point(0.46 + 0.01 * i, 0.4) for i in range(6)])
    studio.wait("absorbing", lambda s: s["voxels"] < before)
    press(studio, "growPause")
    state = studio.wait_idle("the pause", lambda s: not s["playing"])
    need(state["voxels"] > 0, "all was absorbed at once")
    press(studio, "growStep")
    studio.wait_idle("one step more", lambda s: s["voxels"] < state["voxels"])
    studio.key("ctrl+z")
    studio.wait_idle("undo", lambda s: s["voxels"] == before)
    pace(studio, 0)
    studio.move(studio.view_point(0.5, 0.9))
    studio.key("r")


@test.step(after=[grow])
def edit(studio):
    press(studio, "editFold")
    before = studio.state()["voxels"]
    studio.type_number("editAmount", -3)
    press(studio, "editPerform")
    state = studio.wait_idle("a smaller segment", lambda s: s["message"].startswith("Edit segment"))
    need(state["voxels"] < before, "a margin of -3 mm took nothing away")
    press(studio, "editFold")


@test.step(after=[look_at_list])
def brush(studio):
    """The drill takes away from the segment, and the scan stays."""
    before = studio.state()
    choose(studio, "d", "drill")
    press(studio, "drillOnSegment")
    studio.key("e")
    studio.drag([studio.view_point(0.45, 0.4), studio.view_point(0.5, 0.48)])
    studio.wait("the mask", lambda s: s["hint"].startswith("The mask follows") and "removed from Scalp" in s["hint"])
    studio.drag([studio.view_point(0.47 + 0.01 * i, 0.44) for i in range(5)])
    state = studio.wait_idle("the brush", lambda s: s["message"].startswith("Brush segment"))
    need(0 < state["voxels"] < before["voxels"], f"the brush left {state['voxels']} of {before['voxels']} voxels")
    studio.key("Escape")
    press(studio, "drillOnScan")


@test.step
def open_labels(studio, folder):
    write_labels(folder / "labels.seg.nrrd")
    count = len(studio.state()["segments"])
    studio.move(studio.view_point(0.5, 0.9))
    studio.key("ctrl+l")
    studio.type_path("openLabelsDialog", folder / "labels.seg.nrrd")
    state = studio.wait_idle("the labels", lambda s: len(s["segments"]) == count + 2)
    found = {segment["name"]: segment["voxels"] for segment in state["segments"]}
    need(found.get("Core") == 1000 and found.get("Label 3") == 1000, f"the labels became {found}")


@test.step(after=[look_at_list, open_labels])
def numbers(studio):
    press(studio, "numbersFold")
    press(studio, "copyNumbers")
    studio.wait("the copy", lambda s: s["message"].startswith("Copied the numbers of 3"))


def save(studio, folder):
    studio.move(studio.view_point(0.5, 0.9))
    studio.key("F12")
    studio.type_path("screenshotDialog", folder / "window.png")
    studio.wait_idle("the picture", lambda s: s["message"].startswith("Saved picture"))
    studio.key("ctrl+s")
    studio.type_path("saveDialog", folder / "session.json")
    return studio.wait_idle("the session", lambda s: "session.json" in s["message"])


@test.step
def session(studio, folder):
    """Returns the session's path, and the state that was saved."""
    state = save(studio, folder)
    need(state["glErrors"] == 0, f"{state['glErrors']} OpenGL errors")
    studio.quit()
    return folder / "session.json", state


@test.step
def operations_of_session(session):
    names = [operation["op"] for operation in operations(session[0])]
    for name in ("seed", "grow", "show generation", "segment", "growth rules", "absorb", "edit segment", "brush segment",
                 "load labels"):
        need(name in names, f"the session has no {name}: {names}")


@test.step
def path_of_labels(session):
    loaded = next(operation for operation in operations(session[0]) if operation["op"] == "load labels")
    need(loaded["path"] == "labels.seg.nrrd", f"the label map's path is {loaded['path']}")


@test.step
def replay(arguments, session, folder):
    path, state = session
    compare_with_replay(arguments.vstudio, path, folder / "window.png", state["viewport"], folder)


@test.step
def voxels_of_replay(arguments, session):
    path, state = session
    table = run(arguments.vstudio, "stats", path)
    need(any(segment["voxels"] > 0 for segment in state["segments"]), "no segment has voxels")
    for segment in state["segments"]:
        if segment["voxels"] > 0:
            need(str(segment["voxels"]) in table, f"replayed, {segment['name']} has other voxels:\n{table}")


if __name__ == "__main__":
    sys.exit(test.main(__doc__, "--program", "--vstudio"))
