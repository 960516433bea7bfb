# SPDX-License-Identifier: Apache-2.0
"""Every tool that cuts, by hand: laser, sweep, scissors, keep connected, clip, restore; pasting and moving what was cut."""

import math
import sys

from driver import need, start
from phantom import head
from replay import compare_with_replay, operations, save_and_end
from steps import Steps, generated

test = Steps()


def ellipse(studio, centre, radii, count=12):
    return [studio.view_point(centre[0] + radii[0] * math.cos(2 * math.pi * i / count),
                              centre[1] + radii[1] * math.sin(2 * math.pi * i / count)) for i in range(count)]


def line(studio, begin, end, count=6):
    return [studio.view_point(begin[0] + (end[0] - begin[0]) * i / count, begin[1] + (end[1] - begin[1]) * i / count)
            for i in range(count + 1)]


def choose(studio, key, tool):
    """By its key, as a person's other hand does."""
    studio.move(studio.view_point(0.5, 0.9))
    studio.key(key)
    studio.wait(f"the tool {tool}", lambda s: s["tool"] == tool)


class Done:
    """Waits for one more operation than before, of one kind."""

    def __init__(self, studio):
        self.studio = studio
        self.before = studio.state()["operations"]

    def wait(self, name):
        # The picture too: the next stroke is drawn on what is seen.
        return self.studio.wait_idle(name, lambda s: s["operations"] > self.before and s["message"].startswith(name)
                                     and s["pictureComplete"])


def undo(studio):
    before = studio.state()["operations"]
    studio.key("ctrl+z")
    return studio.wait_idle("undo", lambda s: s["operations"] > before and s["message"].startswith("Undo"))


def redo(studio):
    before = studio.state()["operations"]
    studio.key("ctrl+shift+z")
    return studio.wait_idle("redo", lambda s: s["operations"] > before and s["message"].startswith("Redo"))


@test.step
def studio(display, arguments, folder):
    studio = start(display, arguments.program, folder, [head(folder, arguments.generated)])
    studio.wait_idle("the volume", lambda s: s["pictureComplete"])
    return studio


@test.step
def narrow(studio):
    """A small window has all its buttons too, and small pictures are soon finished."""
    studio.resize(900, 700)
    state = studio.wait_idle("the small window", lambda s: s["viewport"][0] < 500 and s["pictureComplete"])
    right = state["widgets"]["mainWindow"][0] + state["widgets"]["mainWindow"][2]
    for name in ("open", "viewWhole", "cameraTool", "moveTool", "reSeed"):
        need(name in state["widgets"], f"a window 900 pixels wide has no button {name}")
        x, _, width, _ = state["widgets"][name]
        need(x + width <= right, f"the button {name} lies outside the window")


@test.step
def mark(studio):
    """A line that is seen while it is drawn, letters, an area; an eraser; each one operation, undone and done again."""
    choose(studio, "j", "mark")
    done = Done(studio)
    studio.drag(line(studio, (0.4, 0.35), (0.6, 0.35), 12))
    done.wait("Mark")
    studio.click("markText")
    studio.wait("letters", lambda s: s["hint"].startswith("Click where the letters"))
    done = Done(studio)
    studio.click(studio.view_point(0.5, 0.45))
    done.wait("Mark")
    studio.click("markArea")
    done = Done(studio)
    studio.drag(ellipse(studio, (0.45, 0.55), (0.05, 0.04)))
    done.wait("Mark")
    undo(studio)
    redo(studio)
    studio.click("markLine")
    studio.key("r")
    studio.wait("the eraser", lambda s: s["hint"].startswith("Draw over the marks"))
    done = Done(studio)
    studio.drag(line(studio, (0.5, 0.3), (0.5, 0.4), 6))
    done.wait("Mark")
    studio.key("r")
    # Beside the head there is nothing to mark, and no operation.
    before = studio.state()["operations"]
    studio.drag(line(studio, (0.02, 0.95), (0.04, 0.97), 3))
    state = studio.wait_idle("nothing marked", lambda s: "othing was marked" in s["message"])
    need(state["operations"] == before, "a mark on nothing is an operation")
    studio.move(studio.view_point(0.5, 0.4))
    studio.xdotool("mousedown", 1)
    studio.wait("the mark in hand", lambda s: s["hint"].startswith("Marking"))
    studio.key("Escape")
    studio.xdotool("mouseup", 1)
    state = studio.wait_idle("dropped", lambda s: "othing was changed" in s["message"])
    need(state["operations"] == before, "a mark that was dropped is an operation")


@test.step
def laser(studio):
    choose(studio, "b", "laser")
    studio.drag(ellipse(studio, (0.42, 0.4), (0.03, 0.04)))
    studio.wait("the laser's mask", lambda s: s["hint"].startswith("The mask lies on the surface"))
    done = Done(studio)
    studio.drag(line(studio, (0.42, 0.4), (0.47, 0.36)))
    done.wait("Laser")
    undo(studio)
    redo(studio)


@test.step
def sweep(studio):
    """A mask, then its way on the surface; shown first, cut by Enter."""
    choose(studio, "w", "sweep")
    studio.drag(ellipse(studio, (0.55, 0.4), (0.02, 0.03)))
    studio.wait("the sweep's mask", lambda s: s["hint"].startswith("Draw the way"))
    before = studio.state()["operations"]
    studio.drag(line(studio, (0.55, 0.4), (0.62, 0.5), 10))
    state = studio.wait_idle("the way", lambda s: s["hint"].startswith("Enter cuts"))
    need(state["operations"] == before, "a way that is only shown made an operation")
    done = Done(studio)
    studio.key("Return")
    done.wait("Sweep")


@test.step(after=[laser])
def restore_by_drill(studio):
    """What the laser burned is partly filled in again."""
    choose(studio, "d", "drill")
    studio.drag(ellipse(studio, (0.44, 0.38), (0.03, 0.04)))
    studio.wait("the drill's mask", lambda s: s["hint"].startswith("The mask follows"))
    studio.key("r")
    studio.wait("restore", lambda s: "fill in" in s["hint"])
    done = Done(studio)
    studio.drag(line(studio, (0.42, 0.4), (0.44, 0.38), 3))
    done.wait("Drill")
    studio.key("r")
    studio.wait("cutting again", lambda s: "to drill" in s["hint"])


@test.step(after=[restore_by_drill])
def fill(studio):
    """Material by the drill, seen at once; its intensity from the scan; taken away; and a hole that the scissors fill."""
    choose(studio, "d", "drill")
    studio.key("Escape")
    studio.click("drillOnMaterial")
    studio.wait("material", lambda s: "adds material" in s["hint"])
    studio.drag(ellipse(studio, (0.55, 0.55), (0.03, 0.04)))
    studio.wait("the drill's mask", lambda s: s["hint"].startswith("The mask follows"))
    done = Done(studio)
    studio.drag(line(studio, (0.52, 0.55), (0.58, 0.55), 6))
    done.wait("Fill")
    undo(studio)
    redo(studio)
    studio.click("drillMaterialPick")
    studio.wait("picking", lambda s: s["hint"].startswith("Click where the scan"))
    done = Done(studio)
    studio.click(studio.view_point(0.5, 0.35))
    done.wait("Material")
    studio.key("r")
    studio.wait("taking away", lambda s: "takes material away" in s["hint"])
    done = Done(studio)
    studio.drag(line(studio, (0.56, 0.55), (0.58, 0.55), 3))
    done.wait("Unfill")
    studio.key("r")
    # What the laser burned.
    choose(studio, "x", "scissors")
    studio.wait("a hole", lambda s: s["hint"].startswith("Draw around a hole"))
    done = Done(studio)
    studio.drag(ellipse(studio, (0.445, 0.385), (0.07, 0.08)))
    done.wait("Fill hole")
    studio.click("scissorsOnScan")
    studio.wait("the scan again", lambda s: s["hint"].startswith("Draw around what should go"))


@test.step
def scissors(studio):
    """Outside a stroke and back, then a piece inside one, which is pasted."""
    choose(studio, "x", "scissors")
    studio.click("scissorsOutside")
    done = Done(studio)
    studio.drag(ellipse(studio, (0.5, 0.45), (0.3, 0.3)))
    done.wait("Scissors")
    undo(studio)
    studio.click("scissorsInside")
    done = Done(studio)
    studio.drag(ellipse(studio, (0.5, 0.6), (0.05, 0.05)))
    done.wait("Scissors")


def move_by_hand(studio, operation):
    """Drags the only part, which has just been put there, turns it with Shift and scales it by the wheel, each one operation; two undos."""
    def drag(way):
        x, y = studio.state()["handles"][0]
        more = Done(studio)
        studio.drag([(x + way[0] * i // 8, y + way[1] * i // 8) for i in range(9)])
        return more.wait(operation)["handles"][0]

    state = studio.state()
    need(state["tool"] == "move" and len(state["handles"]) == 1, "the part is not in hand")
    first = state["handles"][0]
    moved = drag((-40, 60))
    need(math.dist(moved, (first[0] - 40, first[1] + 60)) < 4, f"the part is at {moved}, dragged from {first}")
    studio.xdotool("keydown", "shift")
    turned = drag((40, 0))
    studio.xdotool("keyup", "shift")
    need(math.dist(moved, turned) < 3, f"turning moved the part from {moved} to {turned}")
    done = Done(studio)
    studio.move(turned)
    studio.xdotool("click", "--repeat", 3, "--delay", 0, 4)
    state = done.wait(operation)
    need(state["operations"] == done.before + 1, "turning the wheel thrice made more than one operation")
    undo(studio)
    state = undo(studio)
    need(math.dist(state["handles"][0], moved) < 2, "undo did not bring the part back")
    redo(studio)


@test.step(after=[scissors])
def paste_and_move(studio):
    """Beside the object, then moved by hand."""
    done = Done(studio)
    studio.move(studio.view_point(0.5, 0.9))
    studio.key("shift+v")
    done.wait("Paste")
    move_by_hand(studio, "Move part")


@test.step
def clip(studio):
    """A face of the box by its slider: one operation for a drag, which the next one takes the place of."""
    choose(studio, "c", "clip")
    x, y, width, height = studio.wait("the box", lambda s: "clipHi0Slider" in s["widgets"])["widgets"]["clipHi0Slider"]
    right, middle = x + width - 7, y + height // 2

    def slide(begin, end):
        done = Done(studio)
        studio.drag([(begin + (end - begin) * i // 5, middle) for i in range(6)])
        return done.wait("Clip")["operations"] - done.before

    need(slide(right, right - 40) == 1, "one drag of a slider made more than one operation")
    need(slide(right - 40, right - 25) == 2, "a further clip did not take the place of the first (undo, clip)")
    undo(studio)
    redo(studio)


@test.step
def keep_connected(studio):
    """The head is cut in two by a stroke through it; one click keeps the larger piece."""
    studio.move(studio.view_point(0.5, 0.9))
    studio.key("Home")  # a paste has moved the view to show both
    choose(studio, "x", "scissors")
    done = Done(studio)
    studio.drag([studio.view_point(*place) for place in ((0.02, 0.5), (0.98, 0.5), (0.98, 0.53), (0.02, 0.53))])
    done.wait("Scissors")
    choose(studio, "k", "keep")
    done = Done(studio)
    studio.click(studio.view_point(0.25, 0.4))  # the head stands left of what was pasted
    done.wait("Keep connected")


@test.step
def session(studio, folder):
    return save_and_end(studio, folder)


@test.step
def operations_of_session(session):
    names = [operation["op"] for operation in operations(session[0])]
    for name in ("laser", "sweep", "drill", "scissors", "material", "fill", "unfill", "fill hole", "paste", "move part", "clip", "keep connected", "undo", "redo"):
        need(name in names, f"the session has no {name}: {names}")


@test.step
def restoring_of_session(session):
    drill = next(operation for operation in operations(session[0]) if operation["op"] == "drill")
    need(drill.get("restore") is True, f"the drill does not restore: {drill}")


@test.step
def replay(arguments, session, folder):
    path, viewport = session
    compare_with_replay(arguments.vstudio, path, folder / "window.png", viewport, folder)


if __name__ == "__main__":
    sys.exit(test.main(__doc__, "--program", "--vstudio", configure=generated))
