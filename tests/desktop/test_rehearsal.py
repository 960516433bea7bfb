# SPDX-License-Identifier: Apache-2.0
"""What has been rehearsed (doc/decisions/0033) is not compiled any more when a hand does it, and a window rehearses beside itself as long
as it lives."""

import os
import pathlib
import re
import subprocess
import sys
import time

from driver import need, own_home, start
from phantom import SIDE, write_ball_head
from steps import Steps
from test_latency import Phase, circle, draw_mask

test = Steps()

KIND = "uint8:000:small"  # of the head of balls
FIRST_KIND = "int16:000:large"  # what a window rehearses until it knows its scan
# Uses of programs: the size of a draft goes by how fast the machine is, and one that is a power of two has machine code of its own.
FEW = 8


def kept(home):
    """What is kept of programs: of each its binary, and of Mesa's software renderer the machine code of each use."""
    def files(folder):
        return {path.name for path in folder.rglob("*") if path.is_file() and path.name not in ("index", "marker")}
    return files(home / "cache" / "volume-studio" / "programs"), files(home / "cache" / "mesa_shader_cache")


def rehearsing(parent):
    """The processes that rehearse for a window."""
    found = []
    for folder in pathlib.Path("/proc").glob("[0-9]*"):
        try:
            words = (folder / "cmdline").read_bytes().split(b"\0")
            parent_id = int((folder / "stat").read_text().rpartition(")")[2].split()[1])
        except (OSError, ValueError, IndexError):
            continue  # it has ended meanwhile
        if b"--rehearse" in words and (parent is None or parent_id == parent):
            found.append((int(folder.name), b" ".join(words).decode()))
    return found


@test.step
def head(folder):
    path = folder / "head.nrrd"
    write_ball_head(path)
    need(SIDE & (SIDE - 1), "the head of balls is of another kind now")
    return path


@test.step
def rehearsed(arguments, display, folder):
    """Rehearsals to their ends, in an empty home; another one compiles next to nothing."""
    listed = subprocess.run([arguments.vstudio, "devices"], capture_output=True, text=True, env=display.environment, check=True).stdout
    renderer = re.search(r"llvmpipe \([^)]*\)", listed)
    need(renderer, f"no software renderer among the devices:\n{listed}")
    home = folder / "home"
    environment = dict(display.environment, **own_home(home))
    counts = []
    for kind in (FIRST_KIND, KIND, KIND):
        done = subprocess.run([arguments.program, "--rehearse", renderer[0], kind], env=environment, capture_output=True, text=True,
                              check=False)
        need(done.returncode == 0 and not done.stderr.strip(), f"status {done.returncode}: {done.stderr}")
        counts.append([len(files) for files in kept(home)])
    print(f"binaries and machine code: {counts}")
    need(counts[0][0] > 60 and counts[1][1] > counts[0][1] + 10, "programs were left out")
    need(counts[2][0] == counts[1][0] and counts[2][1] <= counts[1][1] + FEW, "the same rehearsal compiled again")
    return renderer[0]


@test.step
def another_renderer_and_kind(arguments, display, folder, rehearsed):
    """For another device nothing is done; a kind that is none is told."""
    environment = dict(display.environment, **own_home(folder / "other_home"))
    for renderer, kind, status in (("another renderer", KIND, 0), (rehearsed, "uint9:000:small", 1)):
        done = subprocess.run([arguments.program, "--rehearse", renderer, kind], env=environment, capture_output=True, text=True,
                              check=False)
        need(done.returncode == status, f"{renderer} {kind}: status {done.returncode}")
        need(status == 0 or ("uint9" in done.stderr and len(done.stderr.splitlines()) == 1), done.stderr)
    need(kept(folder / "other_home") == (set(), set()), "something was compiled")


@test.step
def worked(arguments, display, folder, head, rehearsed):
    """A window on that kind of scan: its picture, a drill stroke, a seed and what grows."""
    home = folder / "home"
    before = kept(home)
    studio = start(display, arguments.program, folder, [head])
    studio.wait_idle("the volume", lambda s: s["pictureComplete"])
    studio.key("d")
    draw_mask(studio, (0.5, 0.5), 0.03)
    studio.wait("the drill's mask", lambda s: s["hint"].startswith("The mask follows"))
    Phase(studio, circle(studio, (0.5, 0.5), 0.05, 1))
    studio.wait_idle("the hole", lambda s: s["stepsDone"] == 1 and s["pictureComplete"])
    studio.key("s")
    studio.wait("the seed tool", lambda s: s["tool"] == "seed")
    studio.drag([studio.view_point(0.58 + 0.01 * i, 0.5) for i in range(4)])
    studio.wait_idle("growth", lambda s: s["generation"] > 0 and not s["playing"] and s["pictureComplete"])
    binaries, code = (after - earlier for after, earlier in zip(kept(home), before))
    print(f"new: {len(binaries)} binaries, machine code of {len(code)} uses")
    need(not binaries, "a program was compiled that had not been rehearsed")
    need(len(code) <= 2 * FEW, "machine code was made that had been made before")
    return studio


@test.step
def nothing_stays(worked):
    """Its rehearsals end with the window, however that ends."""
    window = worked.process.pid
    ids = {process for process, _ in rehearsing(window)}
    print(f"rehearsing beside the window: {sorted(ids)}")
    os.kill(window, 9)
    worked.process.wait()
    until = time.monotonic() + 60
    while {process for process, _ in rehearsing(None)} & ids and time.monotonic() < until:
        time.sleep(0.05)
    need(not {process for process, _ in rehearsing(None)} & ids, "a rehearsal goes on without its window")


if __name__ == "__main__":
    sys.exit(test.main(__doc__, "--program", "--vstudio"))
