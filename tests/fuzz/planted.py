# SPDX-License-Identifier: Apache-2.0
"""Replaying kept inputs ends with an error where one breaks a promise, where a folder is no target's, and where nothing is kept.

usage: planted.py FUZZ_REPLAY
"""
import pathlib
import subprocess
import sys
import tempfile


def replay(files):
    """What becomes of a corpus with these files: their contents by TARGET/NAME."""
    with tempfile.TemporaryDirectory() as name:
        for path, content in files.items():
            file = pathlib.Path(name) / path
            file.parent.mkdir(exist_ok=True)
            file.write_bytes(content)
        done = subprocess.run([sys.argv[1], name], capture_output=True, text=True)
        return done.returncode, done.stdout + done.stderr


def expect(condition, message):
    if not condition:
        sys.exit(f"FAILED: {message}")


status, said = replay({"planted/a": b"nothing", "layout/a": b"1x1x1:uint8"})
expect(status == 0 and "planted/a" in said, f"an input that breaks no promise: {status}, {said}")
status, said = replay({"planted/a": b"nothing", "planted/b": b"?!"})
expect(status != 0 and "a promise was not kept: what was planted" in said, f"an input that breaks one: {status}, {said}")
status, said = replay({"layout/a": b"1x1x1:nothing"})
expect(status == 0 and "refused: " in said, f"an input that is refused: {status}, {said}")
status, said = replay({"nobody/a": b""})
expect(status != 0 and "there is no target 'nobody'" in said, f"a folder that is no target's: {status}, {said}")
status, said = replay({})
expect(status != 0, f"a corpus without inputs: {status}, {said}")
