# SPDX-License-Identifier: Apache-2.0
"""Films by real events: previews, a turntable, growth, key frames; what is written is what ffprobe reads; the document stays as it is, and
the session makes the film again."""

import json
import shutil
import subprocess
import sys

from driver import need, start
from phantom import write_ball_head
from replay import operations, run
from steps import Steps

test = Steps()


def probed(path):
    said = subprocess.run(["ffprobe", "-v", "error", "-count_frames", "-select_streams", "v", "-show_entries",
                           "stream=width,height,nb_read_frames,codec_name:format=duration", "-of", "json", str(path)],
                          check=True, capture_output=True, text=True).stdout
    stream = json.loads(said)["streams"][0]
    return (stream["codec_name"], stream["width"], stream["height"], int(stream["nb_read_frames"]),
            float(json.loads(said)["format"]["duration"]))


def expect(path, codec, size, frames, seconds):
    found = probed(path)
    need(found[:4] == (codec, *size, frames) and abs(found[4] - seconds) < 0.05, f"{path.name} is {found}")


@test.step
def studio(display, arguments, folder):
    need(shutil.which("ffprobe"), "ffmpeg is not installed")
    write_ball_head(folder / "head.nrrd")
    studio = start(display, arguments.program, folder, [folder / "head.nrrd"])
    studio.wait_idle("the volume", lambda s: s["pictureComplete"])
    return studio


@test.step
def grown(studio):
    studio.key("s")
    studio.wait("the seed tool", lambda s: s["tool"] == "seed")
    x, y = studio.view_point(0.5, 0.5)
    studio.drag([(x - 20, y), (x, y + 3), (x + 20, y)])
    studio.wait_idle("growth to end", lambda s: s["generation"] > 3 and not s["playing"])


def choose(studio, choices, begin):
    """By the wheel, which waits while a preview is made."""
    studio.arrive(choices)
    for button in (4, 5):
        for _ in range(10):
            studio.xdotool("click", button)
            state = studio.wait_idle("the preview")
            if state["reports"][choices].startswith(begin):
                return
    need(False, f"{choices} has no choice that begins with '{begin}'")


def save(studio, path):
    studio.click("filmSave")
    studio.type_path("filmFileDialog", path)
    studio.wait_idle("the film", lambda s: s["message"] == f"Saved {path}", seconds=240)
    need(path.exists(), f"{path} is not there")


@test.step(after=[grown])
def turntable(studio, folder):
    before = studio.state()
    studio.key("ctrl+F12")
    studio.wait_idle("the dialog", lambda s: "filmPreview" in s["widgets"])
    studio.focus("filmDialog")
    studio.type_number("filmSeconds", 1)
    choose(studio, "filmSize", "854")
    save(studio, folder / "turn.webm")
    expect(folder / "turn.webm", "vp9", (854, 480), 25, 1)
    after = studio.state()
    need(after["stepsDone"] == before["stepsDone"] and after["generation"] == before["generation"], "the film changed the document")
    need(after["operations"] == before["operations"] + 1, "the film is no operation")


@test.step(after=[turntable])
def growth(studio, folder):
    choose(studio, "filmWhat", "The segment growing")
    save(studio, folder / "growth.mp4")
    expect(folder / "growth.mp4", "h264", (854, 480), 25, 1)


@test.step(after=[growth])
def keys(studio, folder):
    choose(studio, "filmWhat", "From view to view")
    studio.wait_idle("the views", lambda s: "filmAddKey" in s["widgets"])
    studio.click("filmAddKey")
    studio.wait_idle("the first view")
    studio.focus()
    studio.key("ctrl+3")
    studio.wait_idle("the view from a side", lambda s: s["pictureComplete"])
    studio.focus("filmDialog")
    studio.click("filmAddKey")
    studio.wait_idle("the second view")
    save(studio, folder / "views")
    pictures = sorted((folder / "views").glob("*.png"))
    need(len(pictures) == 25, f"{len(pictures)} pictures")
    need(pictures[0].read_bytes() != pictures[-1].read_bytes(), "nothing moves in the film")


@test.step(after=[keys])
def replay(studio, arguments, folder):
    studio.click("filmClose")
    studio.focus()
    studio.key("ctrl+s")
    studio.type_path("saveDialog", folder / "session.json")
    studio.wait_idle("the session", lambda s: "session.json" in s["message"] and not s["unsaved"])
    studio.quit()
    films = [op["file"] for op in operations(folder / "session.json") if op["op"] == "movie"]
    need(films == ["turn.webm", "growth.mp4", "views"], f"the session has {films}")
    again = folder / "again"
    run(arguments.vstudio, "run", folder / "session.json", "-o", again)
    expect(again / "turn.webm", "vp9", (854, 480), 25, 1)
    for number in (1, 13, 25):
        name = f"views_{number:04d}.png"
        said = run(arguments.vstudio, "compare", folder / "views" / name, again / "views" / name, "--mean", 0.5, "--changed", 0.002)
        print(name, said.strip())


if __name__ == "__main__":
    sys.exit(test.main(__doc__, "--program", "--vstudio"))
