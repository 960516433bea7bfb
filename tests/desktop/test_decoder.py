# SPDX-License-Identifier: Apache-2.0
"""Whatever becomes of the decoder, the window says so in one line, keeps what it shows and opens the next scan."""

import pathlib
import random
import sys

from driver import need, start
from phantom import write_ball_head
from steps import Steps

test = Steps()

KILLED = 12  # at random moments
REFUSED = {
    "kill -SEGV $$": "signal 11",
    "kill -KILL $$": "signal 9",
    "kill -STOP $$": "stopped",
    "exit 3": "status 3",
    "ulimit -v 20000; exec {decoder}": "",  # without memory or descriptors: whatever it is that it can still say
    "ulimit -n 5; exec {decoder}": "",
    "head -c 100000 /dev/zero >&3; exit 1": "a message that is none",
}


def processes_of(parent):
    """The processes that it has started, and their own ones."""
    found = []
    for task in pathlib.Path(f"/proc/{parent}/task").iterdir():
        try:
            children = [int(child) for child in (task / "children").read_text().split()]
        except (FileNotFoundError, ProcessLookupError):  # a thread that has ended meanwhile
            continue
        found += children
    return found + [one for child in found for one in processes_of(child)]


class Decoder:
    """A script in the place of the decoder, which does what the test says before it is the real one, or instead."""

    def __init__(self, display, program, folder):
        self.real = pathlib.Path(program).with_name("volume-studio-decoder")
        self.script = folder / "decoder"
        display.environment["VOLUME_STUDIO_DECODER"] = str(self.script)
        self.does("exec {decoder}")

    def does(self, words):
        """In one step: it may be asked for at any moment."""
        fresh = self.script.with_suffix(".fresh")
        fresh.write_text("#!/bin/sh\n" + words.replace("{decoder}", str(self.real)) + "\n")
        fresh.chmod(0o755)
        fresh.rename(self.script)


@test.step
def decoder(display, arguments, folder):
    need(pathlib.Path(arguments.program).with_name("volume-studio-decoder").exists(), "there is no decoder beside the program")
    return Decoder(display, arguments.program, folder)


@test.step
def studio(display, arguments, folder, decoder):
    for name in ("first.nrrd", "second.nrrd"):
        write_ball_head(folder / name)
    studio = start(display, arguments.program, folder, [folder / "first.nrrd"])
    studio.wait_idle("the first scan", lambda s: s["pictureComplete"])
    return studio


def open_second(studio, folder):
    studio.key("ctrl+o")
    studio.type_path("openDialog", folder / "second.nrrd")


def need_as_before(studio, what):
    """The first scan is shown, can be looked at, and nothing runs that was started to read another, but for the decoder that waits."""
    state = studio.wait_idle("the first scan again", lambda s: s["pictureComplete"] and not s["loading"])
    need(state["title"].startswith("first"), f"{what}: the window shows {state['title']}")
    studio.wait(f"the decoder to be gone ({what})", lambda s: len(processes_of(studio.process.pid)) <= 1, seconds=300)


def close_refusal(studio):
    """The dialog that says why nothing was opened. Returns its words."""
    state = studio.wait("the refusal", lambda s: "closeOpenFailed" in s["widgets"])
    studio.click("closeOpenFailed")
    studio.wait("the refusal to close", lambda s: "openFailed" not in s["windows"])
    studio.focus()
    return state["message"]


@test.step
def refused(studio, decoder, folder):
    for script, said in REFUSED.items():
        decoder.does(script)
        open_second(studio, folder)
        message = close_refusal(studio)
        need("second.nrrd" in message and said in message and "\n" not in message, f"after '{script}' it says: {message}")
        need_as_before(studio, script)


@test.step(after=[refused])
def stalled(studio, decoder, folder):
    """One that does nothing without end is given up."""
    decoder.does("exec sleep 600")
    open_second(studio, folder)
    studio.wait("the offer to give up", lambda s: "giveUp" in s["widgets"])
    studio.click("giveUp")
    studio.wait("giving up", lambda s: s["message"].startswith("Given up"))
    need_as_before(studio, "giving up")


@test.step(after=[stalled])
def killed_at_random(studio, decoder, folder):
    """The whole scan or one line."""
    chance = random.Random(20)
    opened = 0
    for _ in range(KILLED):
        signal, after = chance.choice(("KILL", "SEGV", "TERM")), chance.uniform(0, 0.08)
        decoder.does(f"(exec 3>&-; sleep {after:.3f}; kill -{signal} $$) & exec {{decoder}}")
        open_second(studio, folder)
        state = studio.wait("an end", lambda s: "closeOpenFailed" in s["widgets"] or
                            (s["title"].startswith("second") and not s["loading"]))
        if "closeOpenFailed" in state["widgets"]:
            message = close_refusal(studio)
            need("second.nrrd" in message and "\n" not in message, f"killed after {after:.3f} s it says: {message}")
            continue
        opened += 1
        decoder.does("exec {decoder}")
        studio.wait_idle("the second scan", lambda s: s["pictureComplete"])
        studio.key("ctrl+o")
        studio.type_path("openDialog", folder / "first.nrrd")
        studio.wait_idle("the first scan", lambda s: s["title"].startswith("first") and s["pictureComplete"])
    print(f"{opened} of {KILLED} were opened before the signal")
    need_as_before(studio, "the last one")


@test.step(after=[killed_at_random])
def goes_on(studio, decoder, folder):
    decoder.does("exec {decoder}")
    open_second(studio, folder)
    studio.wait_idle("the second scan", lambda s: s["title"].startswith("second") and s["pictureComplete"])
    studio.quit()


if __name__ == "__main__":
    sys.exit(test.main(__doc__, "--program"))
