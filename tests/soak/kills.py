# SPDX-License-Identifier: Apache-2.0
"""The window and `vstudio run` are killed at random moments of random work: what was finished is there, and nothing is torn.

usage: kills.py --program volume-studio --vstudio vstudio --work FOLDER [--kills N] [--seed N]

A window is killed while a random hand works, by a clock that does not know what the hand does. Its journal then has every operation
that the window had reported, `vstudio recover` brings back all of its whole lines, and so does the next window, which the hand
goes on in. A session that was being saved is the old or the new one, whole. Every other kill is one of `vstudio run`, whose outputs
are each the old or the new one, whole."""

import json
import os
import pathlib
import random
import shutil
import subprocess
import sys
import threading
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "desktop"))

from driver import Silence, need, start  # noqa: E402
from phantom import write_ball_head  # noqa: E402
from steps import Steps  # noqa: E402

from hand import Hand  # noqa: E402

test = Steps()

LONGEST_WORK = 12.0  # seconds until a window is killed
MOST_OPERATIONS = 60  # of one document, before it is left for a fresh one: each next window does all of them again


def journal_folder(folder):
    return folder / "home" / "state" / "volume-studio" / "journals"


def whole_lines(journal):
    return [json.loads(line) for line in journal.read_text().splitlines(keepends=True) if line.endswith("\n")]


def journalled(journal):
    """The operations that its whole lines lead to: of one that went on the last line counts."""
    operations = []
    for line in whole_lines(journal):
        if "operation" in line:
            operations[line["n"]:] = [line["operation"]]
    return operations


class Killed:
    """Kills a process after some seconds, whatever it does then."""

    def __init__(self, process, seconds):
        self.timer = threading.Timer(seconds, process.kill)
        self.timer.start()

    def end(self):
        self.timer.cancel()
        self.timer.join()


class Windows:
    """One window after another, each of which takes over what the one before had done when it was killed."""

    def __init__(self, display, arguments, folder):
        self.display, self.arguments, self.folder = display, arguments, folder
        self.chance = random.Random(arguments.seed)
        self.home = folder / "home"
        self.session = folder / "saved.json"
        self.kept = []  # the operations that the next window has to bring back
        self.counts = {"kills": 0, "operations": 0, "recovered": 0, "saved": 0, "in a stroke": 0}
        write_ball_head(folder / "head.nrrd")

    def window(self):
        """A window that has what the last one had, or a fresh document."""
        place = self.folder / "window"
        shutil.rmtree(place, ignore_errors=True)
        place.mkdir()
        if not self.kept:
            studio = start(self.display, self.arguments.program, place, [self.folder / "head.nrrd"], home=self.home)
            studio.wait_idle("the volume", lambda s: s["pictureComplete"])
            return studio
        studio = start(self.display, self.arguments.program, place, home=self.home)
        studio.wait("the offer", lambda s: "recover0" in s["widgets"])
        need("recover1" not in studio.state()["widgets"], "more than one document is offered")
        studio.click("recover0", lasting=True)
        studio.wait_idle("the recovery", lambda s: s["operations"] == len(self.kept) and s["viewRect"], seconds=300)
        self.counts["recovered"] += 1
        return studio

    def one(self):
        studio = self.window()
        hand = Hand(studio, self.chance, self.session)
        death = Killed(studio.process, self.chance.uniform(0.2, LONGEST_WORK))
        try:
            while True:
                hand.act()
        except Silence:
            pass
        finally:
            death.end()
        need(studio.process.wait() == -9, f"the window ended with {studio.process.returncode} by itself, after {hand.done[-6:]}")
        studio.send("mouseup", 1, "mouseup", 3)  # which the window did not live to see
        self.counts["kills"] += 1
        self.counts["in a stroke"] += hand.done[-1].startswith("stroke")
        self.judge(studio)

    def judge(self, studio):
        journals = sorted(journal_folder(self.folder).glob("*.jsonl"))
        need(len(journals) == 1, f"there are {len(journals)} journals")
        self.kept = journalled(journals[0])
        reported = studio.written()["operations"]
        need(len(self.kept) >= reported, f"the window had reported {reported} operations, the journal has {len(self.kept)}")
        self.counts["operations"] += reported
        if self.session.exists():
            self.need_whole_session()
        self.need_recovered(journals[0])
        if len(self.kept) > MOST_OPERATIONS or not self.offered():
            self.discard(journals[0])

    def discard(self, journal):
        journal.unlink(missing_ok=True)
        self.kept = []

    def vstudio(self, *words):
        environment = {**os.environ, "XDG_STATE_HOME": str(self.home / "state")}
        return subprocess.run([self.arguments.vstudio, *map(str, words)], capture_output=True, text=True, env=environment)

    def offered(self):
        """Whether the journal has something that no session file has: else there is nothing to recover."""
        return ".jsonl" in self.vstudio("recover", "--list").stdout

    def need_recovered(self, journal):
        place = self.folder / "recovered"
        shutil.rmtree(place, ignore_errors=True)
        place.mkdir()
        done = self.vstudio("recover", journal, "--keep", "-o", place)
        need(done.returncode == 0, f"vstudio recover: {done.stderr}")
        need("left out" not in done.stderr, f"a line of the journal is damaged: {done.stderr}")
        (session,) = place.glob("*.json")
        operations = json.loads(session.read_text())["operations"]
        need(operations == self.kept, f"{len(operations)} operations come back of {len(self.kept)}")

    def need_whole_session(self):
        done = self.vstudio("check", "--no-replay", self.session)
        need(done.returncode == 0, f"the saved session is torn: {done.stdout}{done.stderr}")
        self.counts["saved"] += 1


@test.step
def windows(display, arguments, folder):
    windows = Windows(display, arguments, folder)
    for _ in range((arguments.kills + 1) // 2):
        windows.one()
    print(f"windows: {windows.counts}", flush=True)


OPERATIONS = [{"op": "view", "range": [60, 255]},
              {"op": "peel", "layers": 6, "mask": {"shape": "ellipse", "points": [[500, 250], [730, 480]]}},
              {"op": "seed", "voxels": [[30, 30, 30]], "range": [60, 255]}, {"op": "grow", "generations": 8},
              {"op": "labels", "file": "labels.nrrd"}, {"op": "sculpture", "file": "sculpture.nrrd"},
              {"op": "picture", "file": "picture.png", "size": [320, 240], "samples": 1},
              {"op": "movie", "file": "film", "size": [64, 48], "samples": 1, "rate": 10,
               "shots": [{"shot": "still", "seconds": 0.5, "orbit": "turntable"}]}]


def contents(place):
    return {str(path.relative_to(place)): path.read_bytes() for path in place.rglob("*") if path.is_file()}


class Runs:
    """Runs of a session that write files of all kinds, over those that another session has written."""

    def __init__(self, arguments, folder):
        self.vstudio, self.folder = arguments.vstudio, folder
        self.chance = random.Random(arguments.seed + 1)
        self.sessions = {}
        for name, layers in (("older", 3), ("newer", 6)):
            operations = [dict(operation, **({"layers": layers} if operation["op"] == "peel" else {})) for operation in OPERATIONS]
            operations[3] = {"op": "grow", "generations": layers}
            path = folder / f"{name}.json"
            path.write_text(json.dumps({"volumeStudioSession": 2, "volume": {"phantom": "head", "dims": [60, 60, 60]},
                                        "operations": operations}))
            self.sessions[name] = path
        self.whole = {name: self.written(name) for name in self.sessions}
        began = time.monotonic()
        self.written("newer")
        self.seconds = time.monotonic() - began

    def command(self, name, place):
        return [self.vstudio, "run", self.sessions[name], "-o", place, "--save", place / "saved.json"]

    def written(self, name):
        place = self.folder / f"whole_{name}"
        shutil.rmtree(place, ignore_errors=True)
        place.mkdir()
        subprocess.run(self.command(name, place), check=True, capture_output=True)
        return contents(place)

    def one(self):
        place = self.folder / "killed"
        shutil.rmtree(place, ignore_errors=True)
        shutil.copytree(self.folder / "whole_older", place)
        process = subprocess.Popen(self.command("newer", place), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        death = Killed(process, self.chance.uniform(0, 0.95 * self.seconds))
        killed = process.wait() == -9
        death.end()
        self.judge(place)
        subprocess.run(self.command("newer", place), check=True, capture_output=True)
        left = set(contents(place)) - set(self.whole["newer"])
        need(not left, f"the next run has not cleared what the killed one left: {left}")
        return killed

    def judge(self, place):
        found = contents(place)
        steady = {name for name in self.whole["newer"] if not name.endswith((".json", ".state"))}  # others hold times and places
        torn = [name for name in steady if found.get(name) not in (self.whole["older"][name], self.whole["newer"][name])]
        torn = [name for name in torn if not (name.startswith("film/") and name not in found)]  # a folder has one file after another
        need(not torn, f"torn: {torn}")
        json.loads(found["report.json"])
        done = subprocess.run([self.vstudio, "check", "--no-replay", str(place / "saved.json")], capture_output=True, text=True)
        need(done.returncode == 0 and "whole and fits" in done.stdout, f"the session is torn: {done.stdout}{done.stderr}")


@test.step
def runs(arguments, folder):
    runs = Runs(arguments, folder)
    killed = sum(runs.one() for _ in range(arguments.kills // 2))
    print(f"runs: {arguments.kills // 2}, {killed} of them killed before they ended", flush=True)


def options(parser):
    parser.add_argument("--kills", type=int, default=5)
    parser.add_argument("--seed", type=int, default=1)


if __name__ == "__main__":
    sys.exit(test.main(__doc__, "--program", "--vstudio", configure=options))
