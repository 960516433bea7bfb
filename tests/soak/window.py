# SPDX-License-Identifier: Apache-2.0
"""A random hand works on the window for long: the window stays, says nothing that is not known, and undone to the start the document
is the one that it was, as the session that is saved then says by its state and by its log.

usage: window.py --program volume-studio --vstudio vstudio --work FOLDER [--actions N] [--seed N]"""

import json
import pathlib
import random
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "desktop"))

from driver import need, start  # noqa: E402
from phantom import write_ball_head  # noqa: E402
from replay import run  # noqa: E402
from steps import Steps  # noqa: E402

from hand import Hand  # noqa: E402

test = Steps()

UNDO_STEPS = 5000  # more than any hand has made
KNOWN = ("note: ", "QStandardPaths: XDG_RUNTIME_DIR not set")  # how lines begin that the program may say


def session_with_outputs(session, path):
    """The session's log again, with files of what it leads to at its end."""
    content = json.loads(session.read_text())
    content["operations"] += [{"op": "sculpture", "file": "sculpture.nrrd"}]
    path.write_text(json.dumps(content))
    return path


@test.step
def studio(display, arguments, folder):
    write_ball_head(folder / "head.nrrd")
    studio = start(display, arguments.program, folder, [folder / "head.nrrd"])
    studio.wait_idle("the volume", lambda s: s["pictureComplete"])
    return studio


@test.step
def worked(studio, arguments, folder):
    """So many random actions. A state each time says that the window answers."""
    hand = Hand(studio, random.Random(arguments.seed), folder / "saved.json")
    try:
        for n in range(arguments.actions):
            hand.act()
            if (n + 1) % 100 == 0:
                state = studio.state()
                resident = int(pathlib.Path(f"/proc/{studio.process.pid}/statm").read_text().split()[1]) * 4096 / 2 ** 20
                print(f"{n + 1} actions, {state['operations']} operations, {state['steps']} steps, {resident:.0f} MB", flush=True)
        hand.settle()
    except Exception:
        print("the last actions:", hand.done[-15:], flush=True)
        raise
    return hand


@test.step(after=[worked])
def undone(studio):
    """Undo to the start; the row of the history says how many steps that were."""
    state = studio.state()
    steps = state["stepsDone"]
    need(state["operations"] > 0, "the hand has done nothing")
    for _ in range(UNDO_STEPS):
        if not studio.state()["canUndo"]:
            break
        studio.move(studio.view_point(0.5, 0.5))
        studio.key("ctrl+z")
    state = studio.state()
    need(not state["canUndo"] and state["stepsDone"] == 0, f"{state['stepsDone']} steps cannot be undone")
    print(f"{state['operations']} operations, {steps} steps undone", flush=True)
    need(all(segment["voxels"] == 0 for segment in state["segments"]) and not state["measurements"],
         f"segments or measurements are left: {state['segments']}, {state['measurements']}")


@test.step(after=[undone])
def session(studio, folder):
    studio.wait_idle("calm")
    studio.key("ctrl+shift+s")
    studio.type_path("saveDialog", folder / "end.json")
    studio.wait_idle("the session", lambda s: "end.json" in s["message"] and not s["unsaved"])
    return folder / "end.json"


@test.step
def equal(session, arguments, folder):
    """State and log lead to the same; and that is an untouched sculpture, as that of a session without edits."""
    said = run(arguments.vstudio, "check", session)
    need("equal, to the byte" in said or "no state" in said, f"state and log differ: {said}")
    untouched = folder / "untouched.json"
    untouched.write_text(json.dumps({"volumeStudioSession": 1, "volume": {"path": "head.nrrd"}, "operations": []}))
    sculptures = []
    for name, of in (("start", untouched), ("end", session)):
        (folder / name).mkdir()
        run(arguments.vstudio, "run", session_with_outputs(of, folder / f"{name}_outputs.json"), "-o", folder / name)
        sculptures.append((folder / name / "sculpture.nrrd").read_bytes())
    need(sculptures[0] == sculptures[1], "the sculpture is not the one of the start")


@test.step(after=[session])
def ended(studio):
    state = studio.state()
    need(state["glErrors"] == 0, f"{state['glErrors']} OpenGL errors")
    studio.quit()
    studio.log.seek(0)
    said = [line for line in studio.log.read().splitlines() if line and not line.startswith(KNOWN)]
    need(not said, f"the program said: {said[:20]}")


def options(parser):
    parser.add_argument("--actions", type=int, default=25)
    parser.add_argument("--seed", type=int, default=1)


if __name__ == "__main__":
    sys.exit(test.main(__doc__, "--program", "--vstudio", configure=options))
