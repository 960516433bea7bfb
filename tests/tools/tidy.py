# SPDX-License-Identifier: Apache-2.0
"""tools/tidy finds faults that are planted in a small repository: in changed and in new sources, in headers through a source that
includes them, and everywhere when the recorded commit is not there; and nothing in what has not changed.

usage: tidy.py ROOT
"""
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(sys.argv[1])
CLEAN = "int {name}(int x) {{ return x; }}\n"
FAULT = "int* {name}Nowhere() {{ return 0; }}\n"  # modernize-use-nullptr
HEADER = "#pragma once\ninline " + CLEAN
SOURCES = {"src/one.cpp": CLEAN.format(name="one"), "src/two.cpp": FAULT.format(name="two"),
           "bench/three.cpp": '#include "shared.h"\n' + CLEAN.format(name="three"), "src/shared.h": HEADER.format(name="shared")}


def expect(condition, message):
    if not condition:
        sys.exit(f"FAILED: {message}")


class Repository:
    """A copy of the tool with sources of its own, one of which has a fault from the start."""

    def __init__(self, root):
        self.root = root
        for name, text in SOURCES.items():
            self.write(name, text)
        (root / "tools").mkdir()
        shutil.copy(ROOT / "tools" / "tidy", root / "tools")
        shutil.copy(ROOT / ".clang-tidy", root)
        self.write(".gitignore", "/build/\n")
        self.git("init", "-q")
        self.git("add", ".")
        self.git("-c", "user.name=test", "-c", "user.email=test", "commit", "-q", "-m", "all")
        self.base = self.git("rev-parse", "HEAD")

    def git(self, *arguments):
        return subprocess.run(["git", *arguments], cwd=self.root, check=True, capture_output=True, text=True).stdout

    def write(self, name, text):
        path = self.root / name
        path.parent.mkdir(exist_ok=True)
        path.write_text(text)

    def tidy(self, *arguments):
        """Exit code and words."""
        sources = sorted(self.root.glob("*/*.cpp"))
        commands = [{"directory": str(self.root), "file": str(source), "command": f"clang++-14 -std=c++20 -I{self.root}/src -c {source}"}
                    for source in sources]
        self.write("build/compile_commands.json", json.dumps(commands))
        (self.root / "tools" / "tidy_base").write_text(self.base)
        done = subprocess.run([self.root / "tools" / "tidy", "--build", self.root / "build", *arguments], cwd=self.root,
                              capture_output=True, text=True)
        return done.returncode, done.stdout + done.stderr

    def expect_found(self, what, *names):
        code, words = self.tidy()
        expect(code != 0, f"{what}: it passes\n{words}")
        for name in ("one", "two", "three", "shared", "new"):
            expect((f"{name}Nowhere()" in words) == (name in names), f"{what}: {name}\n{words}")


def main():
    with tempfile.TemporaryDirectory() as folder:
        repository = Repository(pathlib.Path(folder).resolve())
        code, words = repository.tidy()
        expect(code == 0 and "0 of 3" in words, f"nothing has changed since the base\n{words}")
        code, words = repository.tidy("--all")
        expect(code != 0 and "twoNowhere" in words, f"--all passes over a fault\n{words}")

        repository.write("src/one.cpp", FAULT.format(name="one"))
        repository.expect_found("a changed source", "one")
        repository.write("src/one.cpp", SOURCES["src/one.cpp"])
        repository.write("src/new.cpp", FAULT.format(name="new"))
        repository.expect_found("a new source", "new")
        (repository.root / "src/new.cpp").unlink()
        repository.write("src/shared.h", SOURCES["src/shared.h"] + "inline " + FAULT.format(name="shared"))
        repository.expect_found("a changed header", "shared")
        repository.write("src/shared.h", SOURCES["src/shared.h"])
        repository.write("src/lonely.h", HEADER.format(name="lonely"))
        code, words = repository.tidy()
        expect(code != 0 and "src/lonely.h: no source includes this header" in words, f"a header that is never checked\n{words}")
        (repository.root / "src/lonely.h").unlink()

        repository.base = "0123456789012345678901234567890123456789"
        repository.expect_found("a base that is not there", "two")
    print("passed")


main()
