# SPDX-License-Identifier: Apache-2.0
"""Files dragged from another program and dropped on the window, on its start screen and on an open volume."""

import queue
import subprocess
import sys
import threading

from driver import Failure, need, start
from phantom import write_ball_head, write_labels
from replay import operations
from steps import Steps
from test_start import on_start_screen, scissors

test = Steps()

SOURCE = (1700, 1000)  # beside the window
VIEW = (600, 500)  # of an open volume


class Files:
    """Another program's window that files can be dragged from. What that program hears and does is no input of the studio's, so
    its own lines are waited for."""

    def __init__(self, display, program, *files):
        self.process = subprocess.Popen([program, *map(str, SOURCE), *map(str, files)], env=display.environment,
                                        stdout=subprocess.PIPE, text=True)
        self.lines = queue.Queue()
        threading.Thread(target=lambda: [self.lines.put(line.strip()) for line in self.process.stdout], daemon=True).start()
        self.expect("ready")

    def expect(self, *lines):
        """The first of these that is said from now on."""
        try:
            while (line := self.lines.get(timeout=90)) not in lines:
                pass
        except queue.Empty:
            raise Failure(f"where the files are dragged from nothing of {lines} was said in 90 s") from None
        return line

    def drop(self, studio, taken, place):
        """Lets go there, once the studio has said that it would take them, or not. Returns how it ended: copy, move or ignored."""
        x, y = SOURCE[0] + 50, SOURCE[1] + 30
        studio.move((x, y))
        studio.xdotool("mousedown", 1)
        # One answer to each place: whoever goes on before it has come leaves the studio, and lets go, where nobody asked about.
        for point in ((place[0] + 50, place[1]), place):
            studio.move(point)
            answer = self.expect("welcome", "refused")
        need(answer == ("welcome" if taken else "refused"), f"the files are {answer} at {place}")
        studio.xdotool("mouseup", 1)
        ended = self.expect("copy", "move", "ignored")
        studio.answer("what was dropped")
        return ended

    def close(self):
        self.process.terminate()
        self.process.wait()


@test.step
def files(folder):
    """A volume, a label map of it, what is neither, and where the session will be."""
    volume, labels, text = folder / "head.nrrd", folder / "labels.seg.nrrd", folder / "letter.txt"
    write_ball_head(volume)
    write_labels(labels)
    text.write_text("Dear surgeon, this is no volume.\n")
    return volume, labels, text, folder / "cut.json"


@test.step
def drop(display, arguments, cleanup):
    """A function that drops files on a studio and says how that ended."""
    sources = []

    def close():
        while sources:
            sources.pop().close()

    def drop(studio, *files, taken=True, place=VIEW):
        close()
        sources.append(Files(display, arguments.source, *files))  # stays: what is dropped is asked for afterwards
        return sources[-1].drop(studio, taken, place)

    cleanup.callback(close)
    return drop


@test.step
def studio(display, arguments, folder):
    studio = start(display, arguments.program, folder)
    studio.resize(1230, 870)
    studio.wait_idle("the start screen", on_start_screen)
    return studio


def refuse(studio, drop, text, place=VIEW):
    """Drops what is no volume: one line says so, and nothing else happens."""
    before = studio.state()
    ended = drop(studio, text, place=place)
    need(ended == "copy", f"the other program was told: {ended}")
    state = studio.wait("the refusal", lambda s: "openFailed" in s["widgets"] and not s["loading"])
    said = state["message"]
    need("letter.txt: it is no volume of a known format; " in said and "\n" not in said, f"the refusal is {said!r}")
    need("unsavedEdits" not in state["widgets"] and "dropQuestion" not in state["widgets"], "it asked something")
    for what in ("title", "operations", "unsaved", "tool", "segments", "range"):
        need(state[what] == before[what], f"the text changed {what} from {before[what]} to {state[what]}")
    # While that is to be read, nothing else can be dropped.
    need(drop(studio, text, taken=False) == "ignored", "a window that waits for an answer took a file")
    studio.click("closeOpenFailed")
    studio.wait("the refusal to close", lambda s: "openFailed" not in s["widgets"])


@test.step
def refusal_on_start_screen(studio, drop, files):
    refuse(studio, drop, files[2])
    need(on_start_screen(studio.state()), "the start screen has gone")


@test.step
def volume_on_start_screen(studio, drop, files):
    need(drop(studio, files[0]) == "copy", "a file that was dropped was moved, or ignored")
    studio.wait_idle("the volume", lambda s: s["title"].startswith("head.nrrd") and s["pictureComplete"])
    studio.focus()


@test.step(after=[volume_on_start_screen])
def refusal_on_edits(studio, drop, files):
    """On a volume with edits that are not saved: what is no volume asks nothing."""
    scissors(studio)
    refuse(studio, drop, files[2])
    studio.focus()


@test.step(after=[volume_on_start_screen])
def refusal_on_number(studio, drop, files):
    """A field does not take a file for its text, and does not let the other program move it."""
    x, y, width, height = studio.place_of("rangeHi")
    refuse(studio, drop, files[2], (x + width // 2, y + height // 2))
    studio.focus()


@test.step(after=[volume_on_start_screen])
def saved(studio, files):
    studio.key("ctrl+s")
    studio.type_path("saveDialog", files[3])
    studio.wait_idle("the session", lambda s: "cut.json" in s["message"] and not s["unsaved"])


@test.step(after=[volume_on_start_screen])
def labels_on_volume(studio, drop, files):
    """Another volume may be a label map of this one: the person is asked."""
    drop(studio, files[1])
    studio.click("dropLabels")
    studio.wait_idle("the labels", lambda s: any(segment["name"] == "Core" for segment in s["segments"]))
    need(studio.state()["title"].startswith("head.nrrd"), "the label map was opened as a volume")
    studio.focus()


@test.step(after=[labels_on_volume])
def volume_on_edits(studio, drop, files):
    drop(studio, files[1])
    studio.click("dropVolume")
    studio.click("discardEdits")
    studio.wait_idle("the other volume", lambda s: s["title"].startswith("labels.seg.nrrd") and s["pictureComplete"])
    need(studio.state()["operations"] == 0, "the other volume has the first one's cut")
    studio.focus()


@test.step(after=[saved])
def session_on_volume(studio, drop, files):
    """A session brings its own volume, and its edits."""
    session = files[3]
    need(drop(studio, session) == "copy", "the session was moved, or ignored")
    state = studio.wait_idle("the session", lambda s: "as it was saved" in s["message"] and s["pictureComplete"])
    need(state["title"].startswith("cut.json") or "head" in state["title"], f"the title is {state['title']!r}")
    need(state["operations"] == len(operations(session)), f"the session has {state['operations']} operations")


@test.step
def files_stay(files):
    for path in files:
        need(path.exists(), f"{path} is gone")


@test.step
def end(studio):
    need(studio.state()["glErrors"] == 0, "OpenGL errors")
    studio.quit()


if __name__ == "__main__":
    sys.exit(test.main(__doc__, "--program", "--source"))
