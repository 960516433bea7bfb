# SPDX-License-Identifier: Apache-2.0
"""The driver's promise: whatever it does returns when the program has answered it. The program is stopped while each input is sent,
as it is on a machine that has no time for it, and its state is looked at once when the driver returns."""

import os
import signal
import sys
import threading

from driver import need, start
from phantom import write_ball_head
from steps import Steps

test = Steps()

STOPPED_SECONDS = 0.4


def hold_up(studio):
    """From now on the program sleeps through every input, and wakes up a moment later."""
    act = studio.xdotool
    pid = studio.process.pid

    def held_up(*words, **options):
        os.kill(pid, signal.SIGSTOP)
        os.waitpid(pid, os.WUNTRACED)  # it has stopped
        waker = threading.Timer(STOPPED_SECONDS, os.kill, (pid, signal.SIGCONT))
        waker.start()
        try:
            return act(*words, **options)
        finally:
            waker.join()

    studio.xdotool = held_up


@test.step
def studio(display, arguments, folder):
    """The window; from then on it is held up at every input."""
    volume = folder / "head.nrrd"
    write_ball_head(volume)
    studio = start(display, arguments.program, folder, [volume])
    studio.resize(1000, 760)
    studio.wait_idle("the volume", lambda s: s["pictureComplete"])
    hold_up(studio)
    return studio


@test.step
def keys(studio):
    for key, mode in (("2", "mip"), ("4", "overlay"), ("1", "surface")):
        studio.key(key)
        need(studio.state()["mode"] == mode, f"key {key} led to the mode {studio.state()['mode']}, not {mode}")
    studio.key("F4")
    need("axialSlice" in studio.state()["widgets"], "F4 shows no slices")
    studio.key("F5")
    need("axialSlice" not in studio.state()["widgets"], "F5 leaves the slices")


@test.step
def number(studio):
    studio.type_number("rangeLo", 60)
    need(studio.state()["range"][0] == 60, f"60 was typed, and the range is {studio.state()['range']}")
    studio.type_number("rangeHi", 5000)
    need("rangeNote" in studio.state()["widgets"], "what is wrong with 5000 is not said")
    studio.type_number("rangeHi", 170)
    need(studio.state()["range"] == [60, 170], f"170 was typed, and the range is {studio.state()['range']}")


@test.step
def moved(studio):
    """What an answer moves is clicked where it is then: the tab's page has another height."""
    for tab, there in (("tabIntensity", "intensityCurve"), ("tabRange", "histogram")) * 2:
        studio.click(tab)
        need(there in studio.state()["widgets"], f"{tab} does not show {there}")
        studio.click("functionChoice")
        need("map.ember" in studio.state()["widgets"], "the gallery is not open")
        studio.key("Escape")
        need("map.ember" not in studio.state()["widgets"], "the gallery is still open")


@test.step
def dialog(studio):
    studio.key("ctrl+comma")
    need("preferencesDialog" in studio.state()["windows"], "the preferences are not open")
    x, y, _, height = studio.state()["widgets"]["preferSmooth"]
    studio.click((x + 8, y + height // 2))
    need(studio.state()["smooth"], "a click into a dialog did nothing")
    studio.key("Escape")  # which the dialog has by itself
    need("preferencesDialog" not in studio.state()["windows"], "the preferences are still open")
    studio.focus()


@test.step
def drag(studio):
    studio.move(studio.view_point(0.5, 0.9))
    studio.key("x")
    need(studio.state()["tool"] == "scissors", "the scissors are not in hand")
    before = studio.state()["operations"]
    studio.drag([studio.view_point(*place) for place in ((0.4, 0.3), (0.5, 0.3), (0.5, 0.4), (0.4, 0.4))])
    need(studio.state()["operations"] > before, "the stroke made no operation")
    need(not studio.state()["away"], "the stroke is not done")
    for count in range(2):
        done = studio.state()["stepsDone"]
        studio.key(("ctrl+z", "ctrl+shift+z")[count])
        need(studio.state()["stepsDone"] == done + (-1, 1)[count], f"{('undo', 'redo')[count]} did nothing")


@test.step
def end(studio):
    studio.quit()


if __name__ == "__main__":
    sys.exit(test.main(__doc__, "--program"))
