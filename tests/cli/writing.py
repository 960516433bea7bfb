#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Where a file cannot be written the older one stands, one line says what to do, and nothing half-done lies beside it.

usage: writing.py VSTUDIO [DATA_FOLDER]     (a DICOM segmentation is left out where DATA_FOLDER has no bad/good_dicomdir)

For every command that writes files and every format: a disk that is full, one that may only be read, a folder that is not
there, a pipe and a folder of that name. Full and read-only disks are mounted, which takes the right to (else they are left
out, and it exits 77 if they are): as root, or in a user's own namespace, in which this script begins itself again.
"""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

VSTUDIO = os.path.abspath(sys.argv[1])
DATA = pathlib.Path(sys.argv[2] if len(sys.argv) > 2 else "none")
OLDER = b"older, good file"
GROW = ("--seed", "6,5,4", "--range", "100:255")


def call(*arguments):
    return subprocess.run([VSTUDIO, *map(str, arguments)], capture_output=True, text=True, errors="replace", timeout=300)


def made(*arguments):
    done = call(*arguments)
    assert done.returncode == 0, done.stderr


class Inputs:
    """A small volume, labels, sessions and a journal that commands read."""

    def __init__(self, folder):
        raw = folder / "box.raw"
        raw.write_bytes(bytes(200 if 6 <= x < 18 and 5 <= y < 15 and 4 <= z < 12 else x * 7 % 50
                              for z in range(16) for y in range(20) for x in range(24)))
        self.volume, self.labels, self.session = (folder / name for name in ("box.nrrd", "labels.nrrd", "s.json"))
        made("reduce", raw, "--raw", "24x20x16:uint8", "--by", "1", "-o", self.volume)
        made("grow", self.volume, *GROW, "-o", self.labels)
        self.session.write_text('{"volumeStudioSession": 1, "volume": {"path": "box.nrrd"}, "operations": [{"op": "clip", '
                                '"planes": [{"point": [9, 0, 0], "normal": [1, 0, 0]}]}]}')
        self.series = DATA / "bad" / "good_dicomdir"
        self.series_labels = folder / "series.nrrd"
        if self.series.exists():
            made("grow", self.series, "--seed", "32,32,3", "--range", "0:5000", "-o", self.series_labels)

    def commands(self):
        """What writes: the names of its files, and the command with the place of the first, from which the others follow."""
        volume, labels, session = self.volume, self.labels, self.session
        yield ("a.png",), lambda out: ("render", volume, "--size", "64x48", "-o", out)
        yield ("h.png",), lambda out: ("histogram", volume, "-o", out)
        yield ("h.csv",), lambda out: ("histogram", volume, "-o", volume.with_name("h.png"), "--csv", out)
        for end in (".nrrd", ".nii", ".nii.gz", ".mha"):
            yield ("l" + end,), lambda out: ("grow", volume, *GROW, "-o", out)
        yield ("l.mhd", "l.zraw"), lambda out: ("grow", volume, *GROW, "-o", out)
        yield ("g.nrrd",), lambda out: ("grow", volume, *GROW, "-o", labels.with_name("l.nrrd"), "--generations", out)
        yield ("p.nii",), lambda out: ("phantom", "body", "--size", "24", "-o", out)
        yield ("r.nrrd",), lambda out: ("reduce", volume, "-o", out)
        yield ("w.nrrd",), lambda out: ("sweep", "--dims", "16,16,16", "--mask", "circle:3", "--path", "line:8,8,4:8,8,12",
                                        "-o", out)
        yield ("t.csv",), lambda out: ("stats", labels, "--volume", volume, "--csv", out)
        for end in (".stl", ".ply", ".glb", ".nrrd", ".csv"):
            yield ("e" + end,), lambda out: ("export", labels, "--volume", volume, "-o", out)
        yield ("e.obj", "e.mtl"), lambda out: ("export", labels, "-o", out)
        yield ("v.nrrd",), lambda out: ("export", session, "--what", "volume", "-o", out)
        if self.series.exists():
            yield ("e.dcm",), lambda out: ("export", self.series_labels, "--volume", self.series, "-o", out)
        yield ("s.json", "s.json.state"), lambda out: ("run", session, "-o", volume.with_name("out"), "--save", out)
        yield ("report.json",), lambda out: ("run", session, "-o", out.parent)
        yield ("b.json",), lambda out: ("bench", volume, "--frames", "1", "--parts", "data", "--json", out)
        if shutil.which("ffmpeg"):
            for end in (".webm", ".mp4"):
                yield ("f" + end,), lambda out: ("film", volume, "--size", "64x48", "--shot", "still:0.1:turntable:9", "-o", out)


def wrong_answer(done, name, mentions):
    lines = [line for line in done.stderr.splitlines() if not line.startswith("note: ")]
    if done.returncode != 1 or len(lines) != 1:
        return f"exit code {done.returncode}, {lines}"
    missing = [word for word in (name, *mentions) if word not in lines[0]]
    return f"{missing} is not in: {lines[0]}" if missing else None


def left(place, names):
    """What is in the folder now that was not, and what was and is another."""
    stray = [path.name for path in place.iterdir() if path.name not in (*names, "filling")]
    changed = [name for name in names if (place / name).read_bytes() != OLDER]
    return f"left behind: {stray}, changed: {changed}" if stray or changed else None


def with_older(place, names):
    for path in place.iterdir():
        path.unlink()
    for name in names:
        (place / name).write_bytes(OLDER)


def on_full_disk(place, names, command):
    with_older(place, names)
    try:
        with open(place / "filling", "wb") as file:
            while True:
                file.write(bytes(4096))
                file.flush()
    except OSError:
        pass
    done = call(*command(place / names[0]))
    found = wrong_answer(done, names[0], ["No space left", "make room"]) or left(place, names)
    (place / "filling").unlink()
    return found


def where_one_may_only_read(place, names, command):
    with_older(place, names)
    subprocess.run(["mount", "-o", "remount,ro", place], check=True)
    done = call(*command(place / names[0]))
    subprocess.run(["mount", "-o", "remount,rw", place], check=True)
    return wrong_answer(done, names[0], ["Read-only file system", "choose"]) or left(place, names)


def without_folder(place, names, command):
    gone = place / "gone"
    done = call(*command(gone / names[0]))
    if names[0] == "report.json":  # its folder is made
        return None if done.returncode == 0 else done.stderr
    return wrong_answer(done, names[0], ["gone", "; "]) or ("the folder was made" if gone.exists() else None)


def over_a_pipe(place, names, command):
    os.mkfifo(place / names[0])
    found = wrong_answer(call(*command(place / names[0])), names[0], ["; "])
    if not (place / names[0]).is_fifo():
        found = found or "the pipe was replaced"
    return found


def over_a_folder(place, names, command):
    (place / names[0]).mkdir()
    return wrong_answer(call(*command(place / names[0])), names[0], ["; "])


def rightly(place, names, command):
    """Without any trouble the older files are replaced."""
    with_older(place, names)
    done = call(*command(place / names[0]))
    same = [name for name in names if (place / name).read_bytes() == OLDER]
    return f"{done.stderr}; still as they were: {same}" if done.returncode != 0 or same else None


def tried(trouble, place, names, command):
    shutil.rmtree(place, ignore_errors=True)
    place.mkdir()
    return trouble(place, names, command)


def may_mount():
    script = "d=$(mktemp -d) && mount -t tmpfs -o size=1m tmpfs $d && umount $d && rmdir $d"
    return subprocess.run(["sh", "-c", script], capture_output=True).returncode == 0


def main():
    if not may_mount() and "WRITING_AGAIN" not in os.environ:
        again = ["unshare", "--user", "--map-root-user", "--mount", sys.executable, *sys.argv]
        if shutil.which("unshare") and subprocess.run([*again[:4], "true"], capture_output=True).returncode == 0:
            os.execvpe(again[0], again, {**os.environ, "WRITING_AGAIN": "1"})
    failures, count = [], 0
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        inputs, disk = Inputs(folder), folder / "disk"
        troubles = [(rightly, folder / "place"), (without_folder, folder / "place"), (over_a_pipe, folder / "place"),
                    (over_a_folder, folder / "place")]
        mounts = may_mount()
        if mounts:
            disk.mkdir()
            subprocess.run(["mount", "-t", "tmpfs", "-o", "size=2m", "tmpfs", disk], check=True)
            troubles += [(on_full_disk, disk), (where_one_may_only_read, disk)]
        try:
            for names, command in inputs.commands():
                for trouble, place in troubles:
                    found = trouble(place, names, command) if place == disk else tried(trouble, place, names, command)
                    count += 1
                    if found:
                        failures.append(f"{names[0]} {trouble.__name__}: {found}")
        finally:
            if mounts:
                subprocess.run(["umount", disk], check=True)
    for failure in failures:
        print("WRONG", failure)
    if not mounts:
        print("skipped: disks that are full or may only be read, which only those can mount who have the right to")
    print(f"{count} tried, {len(failures)} wrong")
    return 1 if failures else 0 if mounts else 77


if __name__ == "__main__":
    sys.exit(main())
