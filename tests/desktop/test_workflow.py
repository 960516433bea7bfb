# SPDX-License-Identifier: Apache-2.0
"""A surgeon's way through the program: open a head, peel its top, mark the brain, let it grow, take it back, keep it."""

import math
import sys

from driver import need, start
from phantom import head
from replay import compare_with_replay, operations, run
from steps import Steps, generated

test = Steps()


def ellipse(studio, centre, radii, count=24):
    return [studio.view_point(centre[0] + radii[0] * math.cos(2 * math.pi * i / count),
                              centre[1] + radii[1] * math.sin(2 * math.pi * i / count)) for i in range(count)]


def downwards(start_point, pixels, step=10):
    x, y = start_point
    return [(x, y + d) for d in range(0, pixels, step)] + [(x, y + pixels)]


@test.step
def studio(display, arguments, folder):
    return start(display, arguments.program, folder)


@test.step
def open_by_dialog(studio, arguments, folder):
    volume = head(folder, arguments.generated)
    studio.click("openButton")
    studio.type_path("openDialog", volume)
    state = studio.wait_idle("the volume", lambda s: s["pictureComplete"])
    need(state["title"].startswith(volume.name), f"the title is {state['title']!r}, without {volume.name}")
    need(state["operations"] == 0, "opening made operations")


@test.step(after=[open_by_dialog])
def look_at_top(studio):
    """Left drag in the camera tool: down to look from above. Not an edit."""
    start_point = studio.view_point(0.5, 0.5)
    studio.drag(downwards(start_point, 110))
    studio.wait_idle("the turned picture", lambda s: s["pictureComplete"] and s["operations"] == 0)


@test.step(after=[open_by_dialog])
def mask(studio):
    """The peel tool: sketches a mask and drags down inside it, twice. Returns the mask's points in the view."""
    studio.click("peelTool")
    studio.wait("the peel tool", lambda s: s["tool"] == "peel")
    outline = ellipse(studio, (0.5, 0.38), (0.1, 0.1))
    studio.drag(outline)
    state = studio.wait("the mask", lambda s: s["hint"].startswith("Press inside the mask"))
    need(state["operations"] == 0, "a sketch alone made an operation")
    middle = studio.view_point(0.5, 0.36)
    studio.drag(downwards(middle, 160))
    state = studio.wait_idle("the peel", lambda s: s["operations"] == 2)  # the view it was drawn on, and the peel
    need(state["canUndo"], "a peel cannot be undone")
    studio.drag(downwards(middle, 30))
    studio.wait_idle("the second peel", lambda s: s["operations"] == 3)
    left, top = studio.state()["viewRect"][:2]
    return [(x - left + 0.5, y - top + 0.5) for x, y in outline]  # pixel centres


@test.step(after=[mask])
def put_back(studio):
    """Dragging down and up again changes nothing."""
    before = studio.state()["operations"]
    middle = studio.view_point(0.5, 0.36)
    way = downwards(middle, 40)
    studio.drag(way + way[::-1])
    studio.wait_idle("the empty peel", lambda s: s["message"] == "Nothing was changed")
    need(studio.state()["operations"] == before, "a peel of nothing made an operation")


@test.step(after=[open_by_dialog])
def paused(studio):
    """Seeds on what was opened, which start to grow; then pause, one back, one forth. Returns its last generation and its voxels."""
    studio.key("s")
    studio.wait("the seed tool", lambda s: s["tool"] == "seed")
    studio.type_number("growthSpeed", 1)  # half a minute, in which it is paused
    studio.drag([studio.view_point(0.46 + 0.01 * i, 0.38) for i in range(9)])
    studio.wait("the growth", lambda s: s["generation"] > 3)
    studio.click("growPause")
    state = studio.wait_idle("the pause", lambda s: not s["playing"])
    need(state["mode"] == "segment", f"the region is not shown, the mode is {state['mode']}")
    need(state["generation"] > 1, "nothing has grown")
    grown = (state["generation"], state["voxels"])

    studio.click("growBack")
    studio.wait_idle("one generation back", lambda s: s["generation"] == grown[0] - 1 and s["voxels"] < grown[1])
    studio.click("growStep")
    state = studio.wait_idle("one generation forth", lambda s: s["generation"] == grown[0])
    need(state["voxels"] == grown[1], f"{grown[1]} voxels became {state['voxels']} by going back and forth")
    return grown


@test.step
def undo_and_redo(studio, paused):
    """The drill is undone for good; the last step is undone and redone."""
    studio.key("ctrl+z")
    studio.wait_idle("undo", lambda s: s["canRedo"] and s["voxels"] != paused[1])
    studio.key("ctrl+shift+z")
    state = studio.wait_idle("redo", lambda s: not s["canRedo"])
    need((state["generation"], state["voxels"]) == paused,
         f"redo did not bring {paused} back but {(state['generation'], state['voxels'])}")


@test.step(after=[open_by_dialog])
def drill(studio):
    studio.key("d")
    studio.wait("the drill", lambda s: s["tool"] == "drill")
    studio.key("e")
    corner, opposite = studio.view_point(0.4, 0.6), studio.view_point(0.44, 0.66)
    studio.drag([corner, opposite])
    studio.wait("the drill's mask", lambda s: s["hint"].startswith("The mask follows"))
    before = studio.state()["operations"]
    studio.drag([studio.view_point(0.42 + 0.01 * i, 0.63) for i in range(8)])
    studio.wait_idle("the drilling", lambda s: s["operations"] > before)
    studio.key("Escape")
    studio.wait("the mask to be dropped", lambda s: s["hint"].startswith("Draw the shape"))


@test.step(after=[open_by_dialog])
def session(studio, folder):
    """Saves a picture, the session and the labels, and ends. Returns the session's path and the picture's size."""
    studio.key("F12")
    studio.type_path("screenshotDialog", folder / "window.jpg")
    studio.wait_idle("a refusal", lambda s: s["message"].startswith("Pictures are written as PNG"))
    need(not list(folder.glob("window*")), "a picture of another kind was written")
    studio.key("F12")
    studio.type_path("screenshotDialog", folder / "window.png")
    studio.wait_idle("the picture", lambda s: s["message"].startswith("Saved picture"))
    studio.key("ctrl+s")
    studio.type_path("saveDialog", folder / "session.json")
    studio.wait_idle("the session", lambda s: s["message"].startswith("Saved") and "session.json" in s["message"])
    studio.key("ctrl+e")
    studio.type_path("labelsDialog", folder / "labels.nrrd")
    studio.wait_idle("the labels", lambda s: s["message"].startswith("Exported"))
    for name in ("window.png", "session.json", "labels.nrrd"):
        need((folder / name).exists(), f"{name} was not written")
    state = studio.state()
    need(state["glErrors"] == 0, f"{state['glErrors']} OpenGL errors")
    studio.quit()
    return folder / "session.json", state["viewport"]


@test.step
def operations_of_session(session):
    names = [operation["op"] for operation in operations(session[0])]
    for name in ("view", "peel", "seed", "grow", "rewind", "undo", "redo", "drill"):
        need(name in names, f"the session has no {name}: {names}")


@test.step
def mask_of_session(session, mask):
    drawn = next(operation for operation in operations(session[0]) if operation["op"] == "peel")["mask"]["points"]
    # The pen's own places, unfiltered: every one of them was reported, so the first and each further point is there.
    for point, expected in zip(drawn, mask):
        need(math.dist(point, expected) < 0.01, f"the mask has {point} where the pen was at {expected}")
    need(len(drawn) == len(mask), f"the mask has {len(drawn)} points, the pen made {len(mask)}")


@test.step
def replay(arguments, session, folder):
    path, viewport = session
    compare_with_replay(arguments.vstudio, path, folder / "window.png", viewport, folder)


@test.step
def reopened(display, arguments, folder, session):
    """The same session, opened by the command line."""
    studio = start(display, arguments.program, folder, [session[0]])
    studio.wait_idle("the session", lambda s: "as it was saved" in s["message"] and s["pictureComplete"])
    return studio


@test.step
def same_document(reopened, paused):
    again = reopened.state()
    need((again["generation"], again["voxels"]) == paused, "the session's region is another one")


@test.step
def same_picture(reopened, arguments, folder):
    reopened.move(reopened.view_point(0.5, 0.5))
    reopened.key("F12")
    reopened.type_path("screenshotDialog", folder / "reopened.png")
    reopened.wait_idle("the picture", lambda s: s["message"].startswith("Saved picture"))
    print("reopened picture:", run(arguments.vstudio, "compare", folder / "window.png", folder / "reopened.png",
                                   "--mean", 0.5).strip())
    reopened.quit()


@test.step
def refusal(display, arguments, folder):
    """What cannot be opened is refused in one line, and the program goes on."""
    broken = folder / "broken.nrrd"
    broken.write_text("NRRD0004\n")
    studio = start(display, arguments.program, folder, [broken])
    state = studio.wait("the refusal", lambda s: "openFailed" in s["widgets"])
    need("broken.nrrd" in state["message"] and "\n" not in state["message"], f"the message is {state['message']!r}")


if __name__ == "__main__":
    sys.exit(test.main(__doc__, "--program", "--vstudio", configure=generated))
