# SPDX-License-Identifier: Apache-2.0
"""Pictures at any size, a turntable that is given up and one that is not, and the picture for the clipboard."""

import json
import shutil
import struct
import sys

from driver import need, start
from phantom import write_ball_head
from replay import run
from steps import Steps

test = Steps()


def open_dialog(studio):
    studio.focus()
    studio.key("shift+F12")
    studio.wait("the dialog", lambda s: "pictureDialog" in s["widgets"])


def save_as(studio, path):
    studio.click("pictureSave")
    studio.type_path("pictureFileDialog", path)


def size_of(png):
    return struct.unpack(">II", png.read_bytes()[16:24])


@test.step
def studio(display, arguments, folder):
    volume = folder / "head.nrrd"
    write_ball_head(volume)
    studio = start(display, arguments.program, folder, [volume])
    studio.resize(900, 700)
    studio.wait_idle("the volume", lambda s: s["viewport"][0] < 500 and s["pictureComplete"])
    return studio


@test.step
def picture(studio, folder):
    open_dialog(studio)
    studio.type_number("pictureWidth", 320, "Tab")  # the height follows the view's shape
    save_as(studio, folder / "seen.png")
    state = studio.wait_idle("the picture", lambda s: s["message"].startswith("Saved picture"))
    need("pictureDialog" not in state["widgets"], "the dialog is still open")
    width, height = state["viewport"]
    need(size_of(folder / "seen.png") == (320, round(320 * height / width)), f"{size_of(folder / 'seen.png')}")


@test.step
def give_up(studio, folder):
    """A turntable that is given up leaves the dialog open."""
    open_dialog(studio)
    studio.type_number("pictureCount", 300, "Tab")
    save_as(studio, folder / "many.png")
    studio.wait("the first pictures", lambda s: (folder / "many-002.png").exists())
    studio.click("pictureCancel")
    studio.wait("the word", lambda s: s["message"].startswith("Given up after") and "pictureDialog" in s["widgets"])


@test.step(after=[give_up])
def turntable(studio, folder):
    studio.type_number("pictureCount", 4, "Tab")
    studio.type_number("pictureWidth", 200, "Tab")
    save_as(studio, folder / "turn.png")
    studio.wait_idle("the turntable", lambda s: s["message"].startswith("Saved 4 pictures"))
    turned = [(folder / f"turn-00{n}.png").read_bytes() for n in (1, 2, 3, 4)]
    need(len(set(turned)) == 4, "pictures of the turntable are alike")


@test.step
def clipboard(studio):
    studio.focus()
    studio.key("ctrl+c")
    studio.wait_idle("the clipboard", lambda s: s["message"] == "The picture is on the clipboard")


@test.step
def session(studio, folder):
    studio.key("ctrl+s")
    studio.type_path("saveDialog", folder / "session.json")
    state = studio.wait_idle("the session", lambda s: "session.json" in s["message"])
    need(state["glErrors"] == 0, f"{state['glErrors']} OpenGL errors")
    studio.quit()
    return folder / "session.json"


@test.step
def operations_of_session(session):
    operations = json.loads(session.read_text())["operations"]
    need([operation["op"] for operation in operations if operation["op"] == "picture"] == ["picture"],
         f"the session has {operations}")


@test.step(after=[picture])
def replay(arguments, session, folder):
    """The replay writes the same picture again."""
    again = folder / "again"
    run(arguments.vstudio, "run", session, "-o", again)
    print("replayed picture:", run(arguments.vstudio, "compare", folder / "seen.png", again / "seen.png",
                                   "--mean", 0.5).strip())
    shutil.rmtree(again)


if __name__ == "__main__":
    sys.exit(test.main(__doc__, "--program", "--vstudio"))
