# SPDX-License-Identifier: Apache-2.0
"""Runs a test of the window step by step, so that one failure does not hide what the steps after it would find."""

import argparse
import contextlib
import inspect
import pathlib
import shutil
import subprocess
import time
import traceback

from driver import STARTED, Display, Silence

GIVEN = ("display", "arguments", "folder", "cleanup")  # what is there before the first step; cleanup is an ExitStack
SKIPPED = 77  # for ctest


class Skip(Exception):
    """This machine lacks what the test is about: the whole test ends and counts as skipped."""


class Step:
    def __init__(self, function, after):
        self.function = function
        self.name = function.__name__
        self.takes = list(inspect.signature(function).parameters)
        self.needs = self.takes + [other.__name__ for other in after]


class Steps:
    """The steps of one test, which run in the order in which they are written.

    A step is a function. Its parameters say what it needs: what is in GIVEN, or earlier steps by their names, whose results it is
    given. `after` names steps that it needs without their results. A step that needs one that failed or did not run, or a studio
    that has fallen silent, does not run; all others do."""

    def __init__(self):
        self.steps = []

    def step(self, function=None, *, after=()):
        """Decorator: the function is a step. It stays a plain function for whoever calls it otherwise."""
        if function is None:
            return lambda decorated: self.step(decorated, after=after)
        step = Step(function, after)
        known = {*GIVEN, *(earlier.name for earlier in self.steps)}
        unknown = [name for name in step.needs if name not in known]
        if unknown or step.name in known:
            raise ValueError(f"step {step.name}: {f'no earlier step is called {unknown}' if unknown else 'the name is taken'}")
        self.steps.append(step)
        return function

    def main(self, about, *options, configure=lambda parser: None):
        """Runs the steps with the command line's options, each of which is required and --work besides. Returns the exit code."""
        parser = argparse.ArgumentParser(description=about)
        for option in options:
            parser.add_argument(option, required=True)
        parser.add_argument("--work", required=True, help="folder to work in; emptied first")
        configure(parser)
        arguments = parser.parse_args()
        folder = pathlib.Path(arguments.work)
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        display = Display()
        with contextlib.ExitStack() as cleanup:
            cleanup.callback(display.close)
            cleanup.callback(lambda: [studio.kill() for studio in STARTED])
            return self.run({"display": display, "arguments": arguments, "folder": folder, "cleanup": cleanup})

    def run(self, results):
        """Runs every step that can run, `results` being what is there already. Returns the exit code."""
        bad = []
        for step in self.steps:
            missing = [name for name in step.needs if name not in results]
            if missing:
                bad.append(step.name)
                print(f"NOT RUN {step.name}: it needs {', '.join(missing)}", flush=True)
                continue
            begin = time.monotonic()
            try:
                results[step.name] = step.function(**{name: results[name] for name in step.takes})
                print(f"passed {step.name} ({time.monotonic() - begin:.1f} s)", flush=True)
            except Skip as why:
                print(f"skipped: {why}", flush=True)
                return 1 if bad else SKIPPED
            except Exception as error:  # whatever went wrong, the other steps have their say
                bad.append(step.name)
                picture = photograph(results["display"], results["folder"] / f"failure_{step.name}.png")
                print(f"FAILED {step.name} ({time.monotonic() - begin:.1f} s{picture})\n{traceback.format_exc()}", flush=True)
                if isinstance(error, Silence):
                    results = {name: result for name, result in results.items() if result is not error.studio}
        print(f"{len(bad)} of {len(self.steps)} steps failed or did not run: {', '.join(bad)}" if bad else "passed", flush=True)
        return 1 if bad else 0


def photograph(display, path):
    """What the screen looks like, which helps most; where it is kept, for the report. Nothing without ImageMagick."""
    if not shutil.which("import"):
        return ""
    subprocess.run(["import", "-window", "root", str(path)], env=display.environment, check=False, timeout=60)
    return f", {path}"


def generated(parser):
    """The option of tests that run on a real head where one is installed."""
    parser.add_argument("--generated", action="store_true", help="use the made head even where a real one is installed")
