# SPDX-License-Identifier: Apache-2.0
"""Two windows of one person, who share a folder of journals: each keeps its own, and what one has left behind when it was killed is
offered without what the other has in hand.

usage: two_programs.py --program volume-studio --vstudio vstudio --work FOLDER"""

import os
import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "desktop"))

from driver import need, start  # noqa: E402
from phantom import write_ball_head  # noqa: E402
from steps import Steps  # noqa: E402
from test_recovery import cut, journalled, journals  # noqa: E402

test = Steps()

BEGINS, ENDS = ((0.40, 0.30), (0.50, 0.30), (0.40, 0.55), (0.50, 0.55)), ((0.46, 0.40), (0.56, 0.40), (0.46, 0.65), (0.56, 0.65))


def window(display, arguments, folder, name):
    """A window on a scan of that name, in the shared home; with the scissors in hand."""
    place = folder / name
    place.mkdir()
    volume = folder / f"{name}.nrrd"
    write_ball_head(volume)
    studio = start(display, arguments.program, place, [volume], home=folder / "home")
    studio.wait_idle("the volume", lambda s: s["pictureComplete"])
    take_scissors(studio)
    return studio


def take_scissors(studio):
    studio.focus()
    studio.move(studio.view_point(0.5, 0.5))
    studio.key("x")
    studio.wait("the scissors", lambda s: s["tool"] == "scissors")
    studio.key("n")


def raised(studio):
    """There is no window manager: whose window is worked in has to be on top."""
    studio.xdotool("windowraise", studio.state()["windows"]["mainWindow"])
    studio.focus()


def work(studio, number):
    raised(studio)
    cut(studio, BEGINS[number], ENDS[number])


def journal_of(folder, name):
    (journal,) = [path for path in journals(folder) if f"{name}.nrrd" in path.read_text().splitlines()[0]]
    return journal


def recover(arguments, folder, *words):
    return subprocess.run([arguments.vstudio, "recover", *map(str, words)], capture_output=True, text=True,
                          env={**os.environ, "XDG_STATE_HOME": str(folder / "home" / "state")})


@test.step
def one(display, arguments, folder):
    return window(display, arguments, folder, "one")


@test.step
def other(display, arguments, folder, one):
    return window(display, arguments, folder, "other")


@test.step
def in_turns(one, other, folder):
    """They work in turns, and each journal has its own operations."""
    for number, studio in ((0, one), (0, other), (1, other), (1, one), (2, one)):
        work(studio, number)
    for name, cuts in (("one", 3), ("other", 2)):
        names = [operation["op"] for operation in journalled(journal_of(folder, name))]
        need(names.count("scissors") == cuts, f"the journal of {name} has {names}")


@test.step(after=[in_turns])
def held(arguments, folder):
    """While both run there is nothing to recover, and neither's journal is given away."""
    listed = recover(arguments, folder, "--list").stdout
    need("nothing to recover" in listed, f"work of running windows is listed: {listed}")
    for name in ("one", "other"):
        refused = recover(arguments, folder, journal_of(folder, name), "-o", folder)
        need(refused.returncode == 1 and "in hand" in refused.stderr and len(refused.stderr.splitlines()) == 1,
             f"the journal of {name}: {refused.returncode}, {refused.stderr}")


@test.step(after=[held])
def killed(one, other, folder):
    """One is killed; the other goes on."""
    done = journalled(journal_of(folder, "one"))
    one.process.kill()
    one.process.wait()
    work(other, 2)
    need(journalled(journal_of(folder, "one")) == done, "the journal of the one that was killed has changed")
    return done


@test.step
def third(display, arguments, folder, killed):
    """A third window offers the work of the dead one, and nothing else; two ask for it at once and one gets it."""
    listed = recover(arguments, folder, "--list").stdout
    need("one.nrrd" in listed and "other.nrrd" not in listed, f"what is listed: {listed}")
    place = folder / "third"
    place.mkdir()
    third = start(display, arguments.program, place, home=folder / "home")
    raised(third)
    third.wait("the offer", lambda s: "recover0" in s["widgets"] and "recover1" not in s["widgets"])
    third.click("recover0")
    third.wait_idle("the recovery", lambda s: s["operations"] == len(killed) and s["pictureComplete"])
    need(journalled(journal_of(folder, "one")) == killed, "the new journal is not the old one")
    return third


@test.step(after=[third])
def go_on(third, other, folder, killed):
    """Both go on, each in its own journal; after clean ends none is left."""
    take_scissors(third)
    work(third, 3)
    work(other, 3)
    need(len(journalled(journal_of(folder, "one"))) > len(killed), "what was recovered does not go on")
    names = [operation["op"] for operation in journalled(journal_of(folder, "other"))]
    need(names.count("scissors") == 4, f"the journal of the other has {names}")
    for studio in (third, other):
        raised(studio)
        studio.quit()
    need(not journals(folder), "clean ends left journals behind")


if __name__ == "__main__":
    sys.exit(test.main(__doc__, "--program", "--vstudio"))
