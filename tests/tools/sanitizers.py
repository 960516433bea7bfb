# SPDX-License-Identifier: Apache-2.0
"""Programs built as the presets asan and tsan build ours end with an error for each planted fault, and without one for none.

usage: sanitizers.py ROOT
"""
import json
import os
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(sys.argv[1])
# What each preset's program must say of which fault.
FAULTS = {
    "asan": {"past_the_end": "heap-buffer-overflow", "past_a_vectors_end": "__n < this->size()", "overflow": "signed integer overflow",
             "leak": "LeakSanitizer"},
    "tsan": {"race": "data race"},
}


def expect(condition, message):
    if not condition:
        sys.exit(f"FAILED: {message}")


def run(*command, **options):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, **options)
    return done.returncode, done.stdout + done.stderr


def preset(name):
    """Its own cache variables, and the environment that it is run with."""
    presets = json.loads((ROOT / "CMakePresets.json").read_text())["configurePresets"]
    found = next(one for one in presets if one["name"] == name)
    environment = {key: value.replace("${sourceDir}", str(ROOT)) for key, value in found["environment"].items()}
    return found["cacheVariables"], {**os.environ, **environment}


def build(name, folder):
    variables, environment = preset(name)
    for command in (["cmake", "-S", ROOT / "tests" / "tools" / "sanitizers", "-B", folder, "-G", "Ninja",
                     *(f"-D{key}={value}" for key, value in variables.items())], ["cmake", "--build", folder]):
        code, words = run(*command, env=environment)
        expect(code == 0, f"{name}: {words}")
    return folder / "planted_faults", environment


def main():
    for name, faults in FAULTS.items():
        with tempfile.TemporaryDirectory() as folder:
            program, environment = build(name, pathlib.Path(folder))
            code, words = run(program, "none", env=environment)
            expect(code == 0 and not words, f"{name}: without a fault the program ended with {code}\n{words}")
            for fault, finding in faults.items():
                code, words = run(program, fault, env=environment)
                expect(code != 0 and finding in words, f"{name}: {fault} ended with {code}\n{words}")
    print("passed")


main()
