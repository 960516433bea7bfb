#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes the titles and sentences of the experiments (examples/experiments/index.json) as marks for lupdate on standard output.

usage: case_texts.py ROOT
"""
import json
import pathlib
import sys

index = json.loads((pathlib.Path(sys.argv[1]) / "examples" / "experiments" / "index.json").read_text())
for experiment in index["experiments"]:
    if "thesis" in experiment:  # those that the start screen shows
        for text in (experiment["title"], experiment["about"]):
            print(f'QT_TRANSLATE_NOOP("cases", {json.dumps(text)});')
