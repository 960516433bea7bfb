# SPDX-License-Identifier: Apache-2.0
"""What THIRD_PARTY.md says of other people's packages, and what programs and Debian say: for tools/make_sbom.py and the tests.

Programs name the libraries that they need (readelf), the loader says where those lie (ldd), and dpkg whose they are.
"""
import pathlib
import re
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[1]


def output(*command):
    done = subprocess.run([str(part) for part in command], capture_output=True, text=True, check=False,
                          env={"PATH": "/usr/sbin:/usr/bin:/sbin:/bin", "LC_ALL": "C.UTF-8"})
    if done.returncode:
        raise RuntimeError(f"{' '.join(map(str, command))}: {done.stderr.strip() or done.returncode}")
    return done.stdout


def tables(text):
    """The tables of the document by the heading above: for each package its licence as SPDX writes it, and what it is for."""
    found, heading = {}, None
    for line in text.splitlines():
        if line.startswith("#"):
            heading = line.lstrip("# ")
        cells = [cell.strip() for cell in line.strip("|").split("|")] if line.startswith("| `") else []
        if cells:
            names = re.findall(r"`([^`]+)`", cells[0])
            found.setdefault(heading, {}).update({name: (cells[1], cells[2]) for name in names})
    return found


def declared():
    return tables((ROOT / "THIRD_PARTY.md").read_text())


def needed(program):
    """The libraries that a program or library names itself, by their sonames."""
    return re.findall(r"\(NEEDED\).*\[(.+)\]", output("readelf", "-d", program))


def loaded(program):
    """Where the loader finds all libraries of a program, those of its libraries too: by soname."""
    return {name: pathlib.Path(path) for name, path in re.findall(r"(\S+) => (/\S+)", output("ldd", program))}


def names_of(path):
    """The names by which dpkg may know a file: with or without /usr, and what a link leads to."""
    real = str(path.resolve())
    return list(dict.fromkeys([str(path), real, real.removeprefix("/usr"), f"/usr{path}"]))


def search(names):
    """What dpkg answers for files by their whole names: for each that it knows a package. Asked in portions, as lines have an end."""
    known = {}
    for first in range(0, len(names), 2000):
        done = subprocess.run(["dpkg-query", "--search", *names[first:first + 2000]], capture_output=True, text=True, check=False)
        for line in done.stdout.splitlines():
            packages, name = line.split(": ", 1)
            known[name] = packages.split(",")[0].split(":")[0]
    return known


def owners(paths):
    """The Debian package that each of the files belongs to; files that belong to none are left out."""
    known = search(sorted({name for path in paths for name in names_of(path)}))
    found = {path: next((known[name] for name in names_of(path) if name in known), None) for path in paths}
    return {path: package for path, package in found.items() if package}


def linked(program):
    """The libraries that a program names itself: for each its soname and its file."""
    places = loaded(program)
    return {name: places[name] for name in sorted(needed(program)) if name in places}


def copyright_text(package):
    path = pathlib.Path("/usr/share/doc") / package / "copyright"
    return path.read_text(errors="replace") if path.is_file() else ""


def licences_in(text):
    """The names of all licences in a copyright file that machines can read; nothing for another one."""
    if not text.startswith("Format:"):
        return []
    return sorted({name.strip() for name in re.findall(r"^License:[ \t]*(\S.*)$", text, re.MULTILINE)})


def main_licence(text):
    """The licence of the paragraph for all files (`Files: *`) in a copyright file that machines can read, or an empty text."""
    paragraphs = re.split(r"\n\s*\n", text) if text.startswith("Format:") else []
    chosen = next((one for one in paragraphs if re.search(r"^Files:\s*\*\s*$", one, re.MULTILINE)), "")
    match = re.search(r"^License:[ \t]*(\S.*)$", chosen, re.MULTILINE)
    return match.group(1).strip() if match else ""
