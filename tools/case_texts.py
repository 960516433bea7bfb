#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes what is said of the experiments and in them (examples/experiments: titles, sentences, notes) as marks for lupdate on standard
output.

usage: case_texts.py ROOT
"""
import json
import pathlib
import sys

FOLDER = pathlib.Path(sys.argv[1]) / "examples" / "experiments"
INDEX = FOLDER / "index.json"

index = json.loads(INDEX.read_text())
for experiment in index["experiments"]:
    if "thesis" in experiment:  # those that the start screen shows
        for text in (experiment["title"], experiment["about"]):
            print(f'QT_TRANSLATE_NOOP("cases", {json.dumps(text)});')

notes = {}
for path in sorted(FOLDER.glob("*.json")):
    if path != INDEX:
        for operation in json.loads(path.read_text())["operations"]:
            if operation["op"] == "note":
                notes[operation["text"]] = None  # once, in the order of the sessions
for text in notes:
    print(f'QT_TRANSLATE_NOOP("cases", {json.dumps(text, ensure_ascii=False)});')
