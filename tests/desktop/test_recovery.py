# SPDX-License-Identifier: Apache-2.0
"""The program is killed with a stroke in hand: the next start brings back all but that stroke."""

import json
import sys

from driver import need, start
from phantom import write_ball_head
from replay import compare_with_replay, operations, save_and_end
from steps import Steps

test = Steps()


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


@test.step
def worker(display, arguments, folder):
    """The window that will be killed."""
    volume = folder / "head.nrrd"
    write_ball_head(volume)
    studio = start(display, arguments.program, folder, [volume])
    studio.wait_idle("the volume", lambda s: s["pictureComplete"])
    return studio


@test.step
def work(worker):
    """Cuts, undoes, seeds and grows."""
    worker.move(worker.view_point(0.5, 0.5))
    worker.key("x")
    worker.wait("the scissors", lambda s: s["tool"] == "scissors")
    worker.key("n")
    cut(worker, (0.40, 0.30), (0.46, 0.40))
    cut(worker, (0.50, 0.30), (0.56, 0.40))
    worker.key("ctrl+z")
    worker.wait_idle("undo", lambda s: s["canRedo"])
    seed(worker)


@test.step(after=[work])
def other_window(display, arguments, folder):
    """A second window of the same person sees no work to recover: the first one has it in hand."""
    other_folder = folder / "other"
    other_folder.mkdir()
    other = start(display, arguments.program, other_folder, home=folder / "home")
    try:
        state = other.wait("the start screen", lambda s: "welcome" in s["widgets"])
    finally:
        other.kill()
    need("recover0" not in state["widgets"], "the work of a running window is offered to another")


@test.step(after=[work])
def done(worker, folder):
    """Is killed while a stroke is drawn. Returns the operations that the journal holds."""
    need(len(journals(folder)) == 1, f"there are {len(journals(folder))} journals")
    before = journalled(journals(folder)[0])
    worker.focus()
    worker.move(worker.view_point(0.6, 0.3))
    worker.key("x")
    worker.wait("the scissors", lambda s: s["tool"] == "scissors")
    worker.xdotool("mousedown", 1)
    worker.move(worker.view_point(0.62, 0.35))
    worker.process.kill()
    worker.process.wait()
    worker.send("mouseup", 1)
    after = journalled(journals(folder)[0])
    need(after == before, "the journal changed after the last edit")
    return after


@test.step
def journal(done):
    names = [operation["op"] for operation in done]
    for name in ("scissors", "undo", "seed", "grow"):
        need(name in names, f"the journal has no {name}: {names}")


@test.step
def studio(display, arguments, folder, done):
    """The next window, which offers what was done."""
    studio = start(display, arguments.program, folder)
    studio.wait("the offer", lambda s: "recover0" in s["widgets"] and "recover1" not in s["widgets"])
    return studio


@test.step
def recover(studio, done):
    studio.click("recover0")
    state = studio.wait_idle("the recovery", lambda s: s["operations"] == len(done) and s["pictureComplete"])
    need(state["unsaved"] and state["canRedo"] is False, "what was recovered counts as saved")


@test.step(after=[recover])
def new_journal(folder, done):
    need(len(journals(folder)) == 1, "the old journal is still there, or the new one is not")
    need(journalled(journals(folder)[0]) == done, "the new journal is not the old one")


@test.step(after=[recover])
def session(studio, folder):
    studio.move(studio.view_point(0.5, 0.5))
    return save_and_end(studio, folder)


@test.step
def operations_of_session(session, done):
    need(operations(session[0])[:len(done)] == done, "the recovered operations are not those that were done")


@test.step(after=[session])
def no_journal(folder):
    need(not journals(folder), "a clean end left a journal behind")


@test.step
def replay(arguments, session, folder):
    path, viewport = session
    compare_with_replay(arguments.vstudio, path, folder / "window.png", viewport, folder)


if __name__ == "__main__":
    sys.exit(test.main(__doc__, "--program", "--vstudio"))
