#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Builds the program twice and compares what is installed, byte for byte (doc/reproducible_builds.md).

The second build has another folder for its sources and for what it makes, sources that seem years older, another umask, language
and zone of time, and comes later. Neither uses ccache, which would give the second what the first has made and prove nothing.
Nothing is stripped. With --part only what is likeliest to differ is built and compared: two libraries, whose sources name
their files and hold the shaders, and the resources of the window.

usage: reproduce.py [--part] [--jobs N] FOLDER      FOLDER is left as it is, to look at what differs; with one that is there
                                                    already, a comparison that was stopped goes on
"""
import argparse
import hashlib
import os
import pathlib
import re
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
NOT_SOURCES = re.compile(r"(build.*|out|\.git|\.cache|__pycache__)$")
SHIPPED = ["vstudio", "volume-studio", "volume-studio-decoder", "sbom"]
PART = ["vs_base", "vs_gl", "vs_desktop_resources_1", "vs_desktop_resources_2", "vs_desktop_resources_3"]
EIGHT_YEARS = 8 * 365 * 24 * 3600  # in seconds

# What surrounds each of the two builds: where sources and build lie in the folder, umask and variables.
SURROUNDINGS = [
    ("first", "first/build", 0o022, {"LC_ALL": "C.UTF-8", "TZ": "UTC"}),
    ("second/by another name", "second/made", 0o027, {"LC_ALL": "C", "LANG": "de_DE.UTF-8", "TZ": "Asia/Tokyo"}),
]


def copy_sources(target, age):
    """Copies what is not there yet or differs, so that a comparison that was stopped goes on; the copies seem `age` seconds older."""
    for folder, folders, names in os.walk(ROOT):
        folders[:] = [name for name in folders if not NOT_SOURCES.match(name)]
        for name in names:
            source = pathlib.Path(folder) / name
            copy = target / source.relative_to(ROOT)
            if name != ".git" and not (copy.is_file() and copy.read_bytes() == source.read_bytes()):
                copy.parent.mkdir(parents=True, exist_ok=True)
                shutil.copy2(source, copy)
                os.utime(copy, (copy.stat().st_mtime - age, copy.stat().st_mtime - age))


def run(log, command, **options):
    with log.open("a") as output:
        done = subprocess.run([str(part) for part in command], stdout=output, stderr=subprocess.STDOUT, check=False, **options)
    if done.returncode:
        sys.exit("".join(log.read_text().splitlines(keepends=True)[-30:]) + f"failed: {command}; all of it in {log}")


def build(source, made, targets, jobs, umask, variables):
    """Configures as the preset `release` does and builds the targets, without ccache."""
    environment = dict(os.environ, CCACHE_DISABLE="1", **variables)
    log = made.parent / f"{made.name}.log"
    surroundings = {"env": environment, "umask": umask, "cwd": source}
    run(log, ["cmake", "--preset", "release", "-B", made, "-DCCACHE=OFF", "-DVOLUME_STUDIO_BUILD_TESTS=OFF"], **surroundings)
    run(log, ["cmake", "--build", made, "-j", jobs, "--target", *targets], **surroundings)
    return log, surroundings


def install(log, surroundings, made, prefix):
    run(log, ["cmake", "--install", made, "--prefix", prefix], **surroundings)


def installed(folder):
    """The files that were installed: for each the SHA-256 of its bytes, and its mode."""
    return {str(path.relative_to(folder)): (digest(path), oct(path.stat().st_mode))
            for path in sorted(folder.rglob("*")) if path.is_file()}


def compiled(folder):
    """The libraries and resources in a build folder: for each the SHA-256 of its bytes. Modes there follow the umask."""
    return {str(path.relative_to(folder)): (digest(path),) for path in sorted(folder.rglob("*"))
            if path.suffix == ".a" or (path.suffix == ".o" and ".rcc" in path.parts)}


def digest(path):
    return hashlib.sha256(path.read_bytes()).hexdigest()


def differences(first, second):
    """What differs between two such lists of files, a line each."""
    for name in sorted(first.keys() | second.keys()):
        if name not in first or name not in second:
            yield f"{name}: only the {'first' if name in first else 'second'} build has it"
        elif first[name] != second[name]:
            yield f"{name}: {' '.join(first[name])} and {' '.join(second[name])}"


def build_and_list(folder, part, jobs):
    """Builds twice; what came of each."""
    for number, (source, made, umask, variables) in enumerate(SURROUNDINGS):
        copy_sources(folder / source, number * EIGHT_YEARS)
        made = folder / made
        log, surroundings = build(folder / source, made, PART if part else SHIPPED, jobs, umask, variables)
        if part:
            yield compiled(made)
        else:
            install(log, surroundings, made, made.parent / "installed")
            yield installed(made.parent / "installed")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--part", action="store_true", help="only what is likeliest to differ, in about a minute")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    arguments = parser.parse_args()
    folder = arguments.folder.resolve()
    folder.mkdir(parents=True, exist_ok=True)
    first, second = build_and_list(folder, arguments.part, arguments.jobs)
    for name, facts in first.items():
        print(f"{facts[0]}  {name}")
    found = list(differences(first, second))
    print("\n".join(["these files differ:", *found]) if found else f"equal: all {len(first)} files, byte for byte")
    return 1 if found or not first else 0


if __name__ == "__main__":
    sys.exit(main())
