# SPDX-License-Identifier: Apache-2.0
"""Every text of the window is in translations/*.ts, translated, with its placeholders, mnemonics and marks."""

import argparse
import collections
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

# What a translation must have as often as its source: places for values, keys of menus, tags, "…" of what asks further.
MARKS = re.compile(r"%L?\d|%n|&|…|</?\w+[^>]*>|\n")


def messages(path):
    found = {}
    for context in ElementTree.parse(path).getroot().findall("context"):
        for message in context.findall("message"):
            translation = message.find("translation")
            key = (context.findtext("name"), message.findtext("source"), message.findtext("comment") or "")
            found[key] = (translation.text or "", translation.get("type"))
    return found


def problems_of(path, update):
    have = messages(path)
    with tempfile.TemporaryDirectory() as folder:
        copy = pathlib.Path(folder) / path.name
        shutil.copy(path, copy)
        subprocess.run([update, copy], check=True)
        wanted = messages(copy)
    for context, source, _ in wanted.keys() - have.keys():
        yield f"{context}: '{source}' is not there; run tools/update_translations.sh and translate it"
    for context, source, _ in have.keys() - wanted.keys():
        yield f"{context}: '{source}' is in no source any more; run tools/update_translations.sh"
    for (context, source, _), (text, kind) in have.items():
        if kind is not None or not text:
            yield f"{context}: '{source}' is {kind or 'empty'}; translate it"
            continue
        counts = collections.Counter(MARKS.findall(source)), collections.Counter(MARKS.findall(text))
        if counts[0] != counts[1]:
            yield f"{context}: '{text}' has {dict(counts[1])}, its source '{source}' has {dict(counts[0])}"
        if (source[:1] == " ", source[-1:] == " ") != (text[:1] == " ", text[-1:] == " "):
            yield f"{context}: '{text}' begins or ends otherwise than '{source}', with or without a space"


def main(root):
    files = sorted((root / "translations").glob("*.ts"))
    problems = [f"{path.name}: {problem}" for path in files
                for problem in problems_of(path, root / "tools" / "update_translations.sh")]
    print("\n".join(problems) or f"{len(files)} translation is complete")
    return 1 if problems or not files else 0


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("root", type=pathlib.Path, help="of the repository")
    sys.exit(main(parser.parse_args().root.resolve()))
