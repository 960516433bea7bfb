# SPDX-License-Identifier: Apache-2.0
"""The program is killed with a stroke in hand: the next start brings back all but that stroke."""

import argparse
import json
import sys

from driver import need, run_test, start
from phantom import write_ball_head
from replay import compare_with_replay, operations


def journals(folder):
    return sorted((folder / "home" / "state" / "volume-studio" / "journals").glob("*.jsonl"))


def journalled(path):
    """The operations that a journal holds, whole lines only."""
    lines = [json.loads(line) for line in path.read_text().splitlines(keepends=True) if line.endswith("\n")]
    return [line["operation"] for line in lines if "operation" in line]


def cut(studio, begin, end):
    before = studio.state()["operations"]
    (x0, y0), (x1, y1) = studio.view_point(*begin), studio.view_point(*end)
    studio.drag([(x0 + (x1 - x0) * i // 5, y0 + (y1 - y0) * i // 5) for i in range(6)])
    studio.wait_idle("the cut", lambda s: s["operations"] > before and s["pictureComplete"])


def seed(studio):
    studio.key("s")
    studio.wait("the seed tool", lambda s: s["tool"] == "seed")
    studio.key("f")
    studio.drag([studio.view_point(0.52 + 0.01 * i, 0.6) for i in range(6)])
    studio.wait("the growth", lambda s: s["playing"] or s["generation"] > 1)
    studio.key("shift+g")
    studio.wait_idle("the pause", lambda s: not s["playing"] and s["generation"] > 1)


def work_and_die(display, arguments, folder, volume):
    """Cuts, undoes, seeds and grows, then is killed while a stroke is drawn. Returns what the journal holds."""
    studio = start(display, arguments.program, folder, [volume])
    studio.wait_idle("the volume", lambda s: s["pictureComplete"])
    studio.move(studio.view_point(0.5, 0.5))
    studio.key("x")
    studio.wait("the scissors", lambda s: s["tool"] == "scissors")
    studio.key("n")
    cut(studio, (0.40, 0.30), (0.46, 0.40))
    cut(studio, (0.50, 0.30), (0.56, 0.40))
    studio.key("ctrl+z")
    studio.wait_idle("undo", lambda s: s["canRedo"])
    seed(studio)

    # A second window of the same person sees no work to recover: the first one has it in hand.
    other_folder = folder / "other"
    other_folder.mkdir()
    other = start(display, arguments.program, other_folder, home=folder / "home")
    state = other.wait("the start screen", lambda s: "welcome" in s["widgets"])
    need("recover0" not in state["widgets"], "the work of a running window is offered to another")
    other.kill()

    need(len(journals(folder)) == 1, f"there are {len(journals(folder))} journals")
    before = journalled(journals(folder)[0])
    studio.focus()
    studio.move(studio.view_point(0.6, 0.3))
    studio.key("x")
    studio.wait("the scissors", lambda s: s["tool"] == "scissors")
    studio.xdotool("mousedown", 1)
    studio.move(studio.view_point(0.62, 0.35))
    studio.process.kill()
    studio.process.wait()
    studio.send("mouseup", 1)
    after = journalled(journals(folder)[0])
    need(after == before, "the journal changed after the last edit")
    names = [operation["op"] for operation in after]
    for name in ("scissors", "undo", "seed", "grow"):
        need(name in names, f"the journal has no {name}: {names}")
    return after


def main(display, arguments, folder):
    volume = folder / "head.nrrd"
    write_ball_head(volume)
    done = work_and_die(display, arguments, folder, volume)

    studio = start(display, arguments.program, folder)
    studio.wait("the offer", lambda s: "recover0" in s["widgets"] and "recover1" not in s["widgets"])
    studio.click("recover0")
    state = studio.wait_idle("the recovery", lambda s: s["operations"] == len(done) and s["pictureComplete"])
    need(state["unsaved"] and state["canRedo"] is False, "what was recovered counts as saved")
    need(len(journals(folder)) == 1, "the old journal is still there, or the new one is not")
    need(journalled(journals(folder)[0]) == done, "the new journal is not the old one")

    studio.move(studio.view_point(0.5, 0.5))
    studio.key("F12")
    studio.type_path("screenshotDialog", folder / "window.png")
    studio.wait_idle("the picture", lambda s: s["message"].startswith("Saved picture"))
    studio.key("ctrl+s")
    session = folder / "session.json"
    studio.type_path("saveDialog", session)
    studio.wait_idle("the session", lambda s: "session.json" in s["message"] and not s["unsaved"])
    need(operations(session)[:len(done)] == done, "the recovered operations are not those that were done")
    state = studio.state()
    need(state["glErrors"] == 0, f"{state['glErrors']} OpenGL errors")
    studio.quit()
    need(not journals(folder), "a clean end left a journal behind")
    compare_with_replay(arguments.vstudio, session, folder / "window.png", state["viewport"], folder)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", required=True)
    parser.add_argument("--vstudio", required=True)
    parser.add_argument("--work", required=True, help="folder to work in; emptied first")
    sys.exit(run_test(main, parser.parse_args()))
