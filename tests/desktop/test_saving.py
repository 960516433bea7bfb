# SPDX-License-Identifier: Apache-2.0
"""A session is saved, goes on being saved to where it lies, is opened from its state, and undone and redone as it was made."""

import json
import sys

from driver import need, start
from phantom import write_ball_head
from replay import run
from steps import Steps

test = Steps()


def cut(studio, where):
    done = studio.state()["stepsDone"]
    studio.key("x")
    studio.wait("the scissors", lambda s: s["tool"] == "scissors")
    x, y = studio.view_point(*where)
    studio.drag([(x, y), (x + 40, y), (x + 40, y + 40), (x, y + 40), (x, y + 2)])
    return studio.wait_idle("the cut", lambda s: s["stepsDone"] == done + 1 and s["pictureComplete"])


def saved(path):
    content = json.loads(path.read_text())
    return content.get("state"), [op["op"] for op in content["operations"]]


@test.step
def studio(display, arguments, folder):
    write_ball_head(folder / "head.nrrd")
    studio = start(display, arguments.program, folder, [folder / "head.nrrd"])
    studio.wait_idle("the volume", lambda s: s["pictureComplete"])
    return studio


@test.step
def first(studio, folder):
    """It asks where, since nobody knows."""
    cut(studio, (0.4, 0.4))
    studio.key("ctrl+s")
    studio.type_path("saveDialog", folder / "session.json")
    studio.wait_idle("the session", lambda s: "session.json" in s["message"] and not s["unsaved"])
    state, names = saved(folder / "session.json")
    need(state and names.count("scissors") == 1, f"saved {names} with the state {state}")


@test.step(after=[first])
def again(studio, folder):
    """It does not ask any more; *Save as* does, and is where it is saved from then on."""
    cut(studio, (0.55, 0.55))
    studio.key("ctrl+s")
    state = studio.wait_idle("the session", lambda s: not s["unsaved"])
    need("saveDialog" not in state["windows"], "it asked where to save what lies there already")
    need(saved(folder / "session.json")[1].count("scissors") == 2, "the second cut was not saved")
    cut(studio, (0.3, 0.6))
    studio.key("ctrl+shift+s")
    studio.type_path("saveDialog", folder / "other.json")
    studio.wait_idle("the other session", lambda s: "other.json" in s["message"] and not s["unsaved"])
    need(saved(folder / "session.json")[1].count("scissors") == 2, "the first session was written over")
    studio.key("ctrl+z")
    studio.wait_idle("undo", lambda s: s["stepsDone"] == 2)
    studio.key("ctrl+s")
    studio.wait_idle("saved again", lambda s: not s["unsaved"])
    need(saved(folder / "other.json")[1][-3:].count("undo") == 1, f"{saved(folder / 'other.json')[1]}")


@test.step(after=[again])
def screenshot(studio, folder):
    studio.key("F12")
    studio.type_path("screenshotDialog", folder / "before.png")
    studio.wait_idle("the picture", lambda s: s["message"].startswith("Saved picture"))
    studio.quit()


@test.step(after=[screenshot])
def reopened(display, arguments, folder, studio):
    """Opened from its state: nothing is replayed, undo and redo go on, the picture is the same to the bit."""
    other = start(display, arguments.program, folder, [folder / "other.json"])
    state = other.wait_idle("the session", lambda s: s["pictureComplete"])
    need("Replay" not in state["message"], f"it was replayed: {state['message']}")
    need(state["stepsDone"] == 2 and not state["unsaved"], f"{state['stepsDone']} steps, unsaved {state['unsaved']}")
    other.key("F12")
    other.type_path("screenshotDialog", folder / "after.png")
    other.wait_idle("the picture", lambda s: s["message"].startswith("Saved picture"))
    need((folder / "before.png").read_bytes() == (folder / "after.png").read_bytes(), "the pictures differ")
    other.key("ctrl+shift+z")
    other.wait_idle("redo", lambda s: s["stepsDone"] == 3)
    for steps in (2, 1, 0):
        other.key("ctrl+z")
        other.wait_idle("undo", lambda s: s["stepsDone"] == steps)
    other.quit()
    said = run(arguments.vstudio, "check", folder / "other.json")
    need("equal, to the byte" in said, said)


@test.step(after=[reopened])
def without_state(display, arguments, folder):
    """Without it, everything is done again, and a notice says so."""
    (folder / "other.json.state").unlink()
    other = start(display, arguments.program, folder, [folder / "other.json"])
    state = other.wait_idle("the session", lambda s: s["pictureComplete"] and s["stepsDone"] == 2)
    need(state["message"].startswith("Replayed"), state["message"])
    other.quit()


@test.step
def another_level(display, arguments, folder):
    """A session that speaks of a finest level that no texture takes opens on a coarser one, and is not saved over."""
    row = bytes(200 if 3 <= x < 2300 else 0 for x in range(2304))
    (folder / "long.raw").write_bytes(b"".join(row if 12 <= z < 24 and 10 <= y < 26 else bytes(2304) for z in range(40) for y in range(40)))
    run(arguments.vstudio, "convert", folder / "long.raw", folder / "long.zarr", "--raw", "2304x40x40:uint8:1,1,1")
    path = folder / "finest.json"
    path.write_text(json.dumps({"volumeStudioSession": 1, "volume": {"path": "long.zarr"}, "operations": [
        {"op": "seed", "range": [150, 255], "voxels": [[2000, 20, 20]]}, {"op": "grow"}]}))
    before = path.read_bytes()
    other = start(display, arguments.program, folder, [path])
    state = other.wait_idle("the session", lambda s: s["message"].startswith("Replayed 2") and s["pictureComplete"])
    need("noticesBadge" in state["widgets"], "it is not said that it was told to another level")
    other.key("ctrl+s")
    other.type_path("saveDialog", folder / "coarser.json")
    other.wait_idle("the session", lambda s: "coarser.json" in s["message"] and not s["unsaved"])
    need(path.read_bytes() == before, "what speaks of another level was written over")
    content = json.loads((folder / "coarser.json").read_text())
    seed = next(op for op in content["operations"] if op["op"] == "seed")
    need(content["volume"]["level"] == 1 and seed["finest"] == [[2000, 20, 20]], content)
    other.quit()


if __name__ == "__main__":
    sys.exit(test.main(__doc__, "--program", "--vstudio"))
