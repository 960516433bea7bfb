# SPDX-License-Identifier: Apache-2.0
"""A journal that is damaged and whose scan has gone is recovered; one that cannot be written says so and goes on later."""

import json
import os
import shutil
import subprocess
import sys

from driver import need, start
from phantom import write_ball_head
from steps import Steps
from test_recovery import cut, journalled, journals

test = Steps()


@test.step
def done(display, arguments, folder):
    """A window that cuts twice and is killed. Returns the operations of its journal."""
    volume = folder / "head.nrrd"
    write_ball_head(volume)
    studio = start(display, arguments.program, folder, [volume])
    studio.wait_idle("the volume", lambda s: s["pictureComplete"])
    studio.move(studio.view_point(0.5, 0.5))
    studio.key("x")
    studio.wait("the scissors", lambda s: s["tool"] == "scissors")
    studio.key("n")
    cut(studio, (0.40, 0.30), (0.46, 0.40))
    cut(studio, (0.50, 0.30), (0.56, 0.40))
    studio.process.kill()
    studio.process.wait()
    return journalled(journals(folder)[0])


@test.step
def damage(folder, done):
    """A line of nonsense, and one that would need what it was; and the scan is moved away."""
    journal = journals(folder)[0]
    with open(journal, "a") as file:
        file.write('{"n":%d,"operation":{"op":"bake"}}\n' % len(done))
        file.write('{"n":%d,"operation":{"op":"undo"}}\n' % (len(done) + 1))
    (folder / "elsewhere").mkdir()
    shutil.move(folder / "head.nrrd", folder / "elsewhere" / "head.nrrd")
    return journal


def recover_by_command(arguments, folder, *words):
    answer = subprocess.run([arguments.vstudio, "recover", *map(str, words)], capture_output=True, text=True,
                            env={**os.environ, "XDG_STATE_HOME": str(folder / "home" / "state")})
    need(answer.returncode == 0, f"vstudio recover {words} ended with {answer.returncode}: {answer.stderr}")
    return answer.stdout + answer.stderr


@test.step
def command(arguments, folder, done, damage):
    """Without a window it lists and recovers the same."""
    listed = recover_by_command(arguments, folder, "--list")
    for word in (damage.name, "head.nrrd", "2 edits", "is not there", "2 lines are left out"):
        need(word in listed, f"{word} is not in the list: {listed}")
    said = recover_by_command(arguments, folder, "--keep", "-o", folder)
    need("left out" in said and "is not there" in said, f"what is missing is not said: {said}")
    session = json.loads((folder / "head-recovered.json").read_text())
    need(session["operations"] == done, "the operations are not those that were done")
    need(damage.exists(), "the journal was not kept")


@test.step(after=[command])
def studio(display, arguments, folder, damage):
    """The next window asks where the scan is."""
    studio = start(display, arguments.program, folder)
    studio.wait("the offer", lambda s: "recover0" in s["widgets"] and "recover1" not in s["widgets"])
    studio.click("recover0")
    studio.wait("the question", lambda s: "findVolumeDialog" in s["windows"])
    return studio


@test.step
def recovered(studio, folder, done, damage):
    studio.type_path("findVolumeDialog", folder / "elsewhere" / "head.nrrd")
    state = studio.wait_idle("the recovery", lambda s: s["operations"] == len(done) and s["pictureComplete"])
    need(state["unsaved"], "what was recovered counts as saved")
    need("noticesBadge" in state["widgets"], "it is not said that something was left out")
    need(not damage.exists() and damage.with_name(damage.name + ".damaged").exists(), "the damaged journal was not set aside")
    need([journalled(path) for path in journals(folder)] == [done], "the new journal has not what was recovered")


@test.step(after=[recovered])
def trouble(studio, folder):
    """Where the journal is taken away and cannot be made again the status bar says so, as long as it is so."""
    place = folder / "home" / "state" / "volume-studio"
    shutil.move(place, folder / "away")
    place.write_text("no folder\n")
    studio.move(studio.view_point(0.5, 0.5))
    studio.key("x")
    studio.wait("the scissors", lambda s: s["tool"] == "scissors")
    shutil.rmtree(folder / "away")
    cut(studio, (0.44, 0.5), (0.48, 0.6))
    studio.wait("the badge", lambda s: "journalBadge" in s["widgets"])
    cut(studio, (0.50, 0.5), (0.54, 0.6))
    need("journalBadge" in studio.state()["widgets"], "the trouble was told once only")
    place.unlink()


@test.step(after=[trouble])
def goes_on(studio, folder, done):
    """Nobody does anything: it goes on by itself, and has all of it."""
    studio.wait("the badge to go", lambda s: "journalBadge" not in s["widgets"])
    (journal,) = journals(folder)
    kept = journalled(journal)
    need(kept[:len(done)] == done, "what was recovered is not in the journal")
    need([operation["op"] for operation in kept].count("scissors") == 4, f"the journal has not all cuts: {kept}")


@test.step(after=[goes_on])
def clean_end(studio, folder):
    studio.quit()
    need(not journals(folder), "a clean end left a journal behind")


if __name__ == "__main__":
    sys.exit(test.main(__doc__, "--program", "--vstudio"))
