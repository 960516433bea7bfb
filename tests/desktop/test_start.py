# SPDX-License-Identifier: Apache-2.0
"""The start screen: what was open is offered again with its picture, what is missing is forgotten, and no edit is lost
on the way back to it."""

import os
import pathlib
import shutil
import sys

from driver import need, start
from phantom import write_ball_head
from replay import operations
from steps import Steps

test = Steps()

DATA = pathlib.Path(os.environ.get("VOLUME_STUDIO_TEST_DATA",
                                   pathlib.Path(__file__).resolve().parents[2].parent / "shared" / "data"))
SERIES = DATA / "bad" / "dicomdir_two_series"


def pictures(folder):
    return list((folder / "home" / "cache" / "volume-studio" / "pictures").glob("*.png"))


def on_start_screen(state):
    return "welcome" in state["widgets"]


def make_examples(folder, volume):
    """Where a package would put them."""
    examples = folder / "home" / "data" / "volume-studio" / "examples"
    examples.mkdir(parents=True)
    shutil.copy(volume, examples / "balls.nrrd")


def scissors(studio, before=0):
    studio.key("x")
    studio.wait("the scissors", lambda s: s["tool"] == "scissors")
    studio.key("n")
    studio.drag([studio.view_point(0.4, 0.3), studio.view_point(0.45, 0.35), studio.view_point(0.5, 0.4)])
    studio.wait_idle("the cut", lambda s: s["operations"] > before and s["unsaved"] and s["pictureComplete"])


def leave(studio, answer):
    studio.key("ctrl+w")
    studio.wait("the question", lambda s: answer in s["widgets"])
    studio.click(answer)


@test.step
def studio(display, arguments, folder):
    volume = folder / "head.nrrd"
    write_ball_head(volume)
    make_examples(folder, volume)
    return start(display, arguments.program, folder)


@test.step
def open_example(studio):
    state = studio.wait("the start screen", lambda s: on_start_screen(s) and "example0" in s["widgets"])
    need("recent0" not in state["widgets"], "something is recent before anything was open")
    need("panels" not in state["widgets"], "panels are shown that have nothing to show")
    names = [name for name in state["widgets"] if name.startswith("example") and name[7:].isdigit()]
    studio.click(f"example{len(names) - 1}")  # the last: those of other packages come first
    state = studio.wait_idle("the example", lambda s: s["pictureComplete"])
    need(state["title"].startswith("balls.nrrd"), f"the title is {state['title']!r}")
    need("panels" in state["widgets"], "the panels are still hidden")


@test.step(after=[open_example])
def picture_is_kept(studio, folder):
    studio.wait("the picture to be kept", lambda s: pictures(folder))


@test.step(after=[open_example])
def leave_without_edits(studio):
    """Nothing is asked; the document is gone, and offered again."""
    studio.key("ctrl+w")
    state = studio.wait_idle("the start screen", lambda s: on_start_screen(s) and "recent0" in s["widgets"])
    need(state["title"] == "Volume Studio" and state["operations"] == 0, f"something is still open: {state['title']}")


@test.step(after=[leave_without_edits])
def open_recent_by_keys(studio):
    """Tab to the first card, Enter."""
    state = studio.focus()
    for _ in range(12):
        if state["focus"] != "recent0":
            state = studio.key("Tab")
    need(state["focus"] == "recent0", "Tab does not reach the first card")
    studio.key("Return")
    studio.wait_idle("the recent volume", lambda s: s["title"].startswith("balls.nrrd") and s["pictureComplete"])


@test.step(after=[open_recent_by_keys])
def cancel(studio):
    """Keeps everything."""
    scissors(studio)
    leave(studio, "cancelLeaving")
    state = studio.wait("the question to close", lambda s: "unsavedEdits" not in s["widgets"])
    need(state["unsaved"] and not on_start_screen(state), "Cancel left the document")
    studio.focus()


@test.step(after=[cancel])
def session(studio, folder):
    """Save writes a session and goes on; the session is recent too."""
    leave(studio, "saveEdits")
    session = folder / "cut.json"
    studio.type_path("saveDialog", session)
    studio.wait_idle("the start screen", lambda s: on_start_screen(s) and "recent1" in s["widgets"])
    need("scissors" in [operation["op"] for operation in operations(session)], "the session lacks the cut")
    return session


@test.step
def open_recent_session(studio, session):
    """The session opens with its cut."""
    studio.click("recent0")
    studio.wait_idle("the session", lambda s: "as it was saved" in s["message"] and s["pictureComplete"])
    need(not studio.state()["unsaved"], "a session that was just opened has unsaved edits")


@test.step(after=[open_recent_session])
def discard(studio, session):
    """Drops further edits."""
    scissors(studio, studio.state()["operations"])
    saved = operations(session)
    leave(studio, "discardEdits")
    studio.wait_idle("the start screen", lambda s: on_start_screen(s) and "recent1" in s["widgets"])
    need(operations(session) == saved, "Discard wrote the session")


@test.step
def forget(display, arguments, folder, studio, session):
    """What is missing cannot be opened, and is forgotten by its button."""
    session.unlink()
    kept = len(pictures(folder))
    studio.quit()
    studio = start(display, arguments.program, folder)
    studio.wait("the missing session", lambda s: "forget_recent0" in s["widgets"] and "recent1" in s["widgets"])
    studio.click("recent0")
    need(on_start_screen(studio.wait_idle("an answer")), "a missing file was opened")
    studio.click("forget_recent0")
    studio.wait("it to be forgotten", lambda s: "recent1" not in s["widgets"])
    need(len(pictures(folder)) == kept - 1, "the picture of what was forgotten is still there")
    need(studio.state()["glErrors"] == 0, "OpenGL errors")
    studio.quit()


@test.step
def open_series(display, arguments, folder):
    """A folder of several series lists them; the one chosen is opened, and stays chosen among the recent ones."""
    if not SERIES.is_dir():
        print(f"skipped: {SERIES} is not here")
        return
    studio = start(display, arguments.program, folder, [SERIES])
    studio.wait("the list of series", lambda s: "openSeries" in s["widgets"])
    studio.focus("seriesDialog")
    studio.key("Home")
    studio.key("Down")
    studio.key("Return")
    state = studio.wait_idle("the series", lambda s: s["title"].startswith(SERIES.name) and s["pictureComplete"])
    need("seriesDialog" not in state["widgets"], "the list of series is still open")
    studio.focus()
    studio.key("ctrl+w")
    studio.wait_idle("the start screen", lambda s: "recent0" in s["widgets"])
    studio.click("recent0")
    studio.wait_idle("the series again", lambda s: s["title"].startswith(SERIES.name) and s["pictureComplete"])
    studio.quit()


if __name__ == "__main__":
    sys.exit(test.main(__doc__, "--program", "--vstudio"))
