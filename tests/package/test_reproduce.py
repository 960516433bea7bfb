# SPDX-License-Identifier: Apache-2.0
"""What is likeliest to differ between two builds is the same in both (tools/reproduce.py), and what differs is found.

usage: test_reproduce.py ROOT WORK       WORK is emptied first
"""
import pathlib
import shutil
import subprocess
import sys

ROOT, WORK = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
sys.path.insert(0, str(ROOT / "tools"))
import reproduce  # noqa: E402


def expect(condition, message):
    if not condition:
        sys.exit(f"FAILED: {message}")


def write(folder, files):
    shutil.rmtree(folder, ignore_errors=True)
    for name, (text, mode) in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
        path.chmod(mode)
    return reproduce.installed(folder)


def check_planted_faults():
    """Another byte, another mode, a file too few and one too many are found; the same files in another place are not."""
    files = {"bin/program": ("code", 0o755), "share/text": ("words", 0o644)}
    first = write(WORK / "one", files)
    expect(not list(reproduce.differences(first, write(WORK / "two", files))), "two equal folders differ")
    for changed in ({**files, "share/text": ("word", 0o644)}, {**files, "bin/program": ("code", 0o700)},
                    {"bin/program": files["bin/program"]}, {**files, "bin/other": ("", 0o755)}):
        found = list(reproduce.differences(first, write(WORK / "two", changed)))
        expect(len(found) == 1, f"{changed.keys() ^ files.keys() or changed}: found {found}")


def main():
    shutil.rmtree(WORK, ignore_errors=True)
    WORK.mkdir(parents=True)
    check_planted_faults()
    done = subprocess.run([sys.executable, ROOT / "tools" / "reproduce.py", "--part", "--jobs", "2", WORK / "builds"],
                          capture_output=True, text=True, check=False)
    print(done.stdout + done.stderr, end="")
    expect(done.returncode == 0, "two builds differ")
    shutil.rmtree(WORK)
    print("passed")


main()
