# SPDX-License-Identifier: Apache-2.0
"""Replays sessions with two vstudio programs and compares all that they write, byte for byte (compressed files by what is in
them), and the seconds that each took. For changes that are meant to change nothing. Exits with 1 when something differs.

usage: compare_programs.py OLD NEW SESSION... [--data FOLDER]
FOLDER holds the volumes whose paths a session gives relative to nothing that is there."""

import argparse
import gzip
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import time


def volume_of(session, data):
    """The session's volume where it can be found; none for blocks; a missing path when it cannot."""
    path = json.loads(session.read_text())["volume"].get("path")
    if path is None:
        return None
    candidates = [session.parent / path] + ([data / path] if data else [])
    return next((place for place in candidates if place.exists()), candidates[-1])


def replay(program, session, volume, folder):
    began = time.monotonic()
    subprocess.run([program, "run", session, "-o", folder, *(["--volume", volume] if volume else [])], check=True,
                   capture_output=True, text=True)
    return time.monotonic() - began


def contents(path):
    data = path.read_bytes()
    if path.name == "report.json":
        return re.sub(rb'"[a-zA-Z]*[mM]illiseconds": *[0-9.e+-]+', b"", data)
    return gzip.decompress(data) if path.suffix == ".gz" else data


def differences(old, new):
    names = {path.relative_to(folder) for folder in (old, new) for path in folder.rglob("*") if path.is_file()}
    for name in sorted(names):
        if not (old / name).exists() or not (new / name).exists():
            yield f"{name}: only one of the two wrote it"
        elif contents(old / name) != contents(new / name):
            yield f"{name}: differs"


def main(options):
    differing = missing = 0
    for session in options.sessions:
        volume = volume_of(session, options.data)
        if volume and not volume.exists():
            print(f"{session}: skipped, there is no {volume}")
            missing += 1
            continue
        with tempfile.TemporaryDirectory() as folder:
            old, new = pathlib.Path(folder) / "old", pathlib.Path(folder) / "new"
            seconds = [replay(program, session, volume, out) for program, out in ((options.old, old), (options.new, new))]
            found = list(differences(old, new))
            files = sum(1 for path in new.rglob("*") if path.is_file())
        differing += bool(found)
        print(f"{session}: {files} files {'the same' if not found else 'DIFFER: ' + '; '.join(found)}"
              f" ({seconds[0]:.1f} s, {seconds[1]:.1f} s)", flush=True)
    print(f"{len(options.sessions) - missing} sessions replayed, {differing} differ, {missing} skipped")
    return 1 if differing else 0


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("old")
    parser.add_argument("new")
    parser.add_argument("sessions", nargs="+", type=pathlib.Path)
    parser.add_argument("--data", type=pathlib.Path)
    sys.exit(main(parser.parse_args()))
