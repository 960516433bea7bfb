# SPDX-License-Identifier: Apache-2.0
"""Replays what was saved in the window without any window, and compares the pictures."""

import json
import subprocess

from driver import Failure, need

# Same device, same shaders, same operations: the pictures could differ only where a ray grazes a surface and the two
# contexts round differently. Half a grey level on average, and one pixel in five hundred, leave room for that and for
# nothing else: one seed stroke or half a peeled layer elsewhere changes far more.
MEAN = 0.5
CHANGED = 0.002


def run(*command):
    done = subprocess.run([str(part) for part in command], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise Failure(f"{' '.join(map(str, command))} ended with {done.returncode}:\n{done.stdout}{done.stderr}")
    return done.stdout


def save_and_end(studio, folder):
    """Saves a picture and the session, and ends the program. Returns the session's path and the picture's size."""
    studio.key("F12")
    studio.type_path("screenshotDialog", folder / "window.png")
    studio.wait_idle("the picture", lambda s: s["message"].startswith("Saved picture"))
    studio.key("ctrl+shift+s")  # asks, wherever it lies
    studio.type_path("saveDialog", folder / "session.json")
    state = studio.wait_idle("the session", lambda s: "session.json" in s["message"] and not s["unsaved"])
    need(state["glErrors"] == 0, f"{state['glErrors']} OpenGL errors")
    studio.quit()
    return folder / "session.json", state["viewport"]


def operations(session):
    return json.loads(session.read_text())["operations"]


def compare_with_replay(vstudio, session, screenshot, viewport, folder):
    """The session, with a picture of the screenshot's size at its end, must give the screenshot."""
    content = json.loads(session.read_text())
    content["operations"].append({"op": "picture", "file": "replay.png", "size": viewport, "samples": 8})
    extended = session.with_name("with_picture.json")
    extended.write_text(json.dumps(content))
    run(vstudio, "run", extended, "-o", folder)
    need((folder / "replay.png").exists(), "the replay wrote no picture")
    print("replayed picture:", run(vstudio, "compare", screenshot, folder / "replay.png", "--mean", MEAN,
                                   "--changed", CHANGED).strip())
    report = json.loads((folder / "report.json").read_text())
    if content.get("state"):
        need("equal, to the byte" in run(vstudio, "check", session), "the session's state is not what its operations lead to")
    return report
