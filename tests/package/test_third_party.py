# SPDX-License-Identifier: Apache-2.0
"""THIRD_PARTY.md names what the built programs link, load and were compiled from: neither less nor more.

usage: test_third_party.py ROOT BUILD
"""
import pathlib
import re
import subprocess
import sys

ROOT, BUILD = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
sys.path.insert(0, str(ROOT / "tools"))
import third_party  # noqa: E402

PROGRAMS = ["vstudio", "volume-studio", "volume-studio-decoder"]
# The compiler's and the system's own headers; what they make of a program is linked from libc6, libgcc-s1 and libstdc++6.
TOOLCHAIN = re.compile(r"(lib(c6|stdc\+\+-\d+|gcc-\d+|crypt)-dev|linux-libc-dev)$")
LICENCE = re.compile(r"[A-Z0-9][\w.+-]*( WITH [\w.-]+)?( (AND|OR) [A-Z0-9][\w.+-]*( WITH [\w.-]+)?)*$|libpng-2\.0$|libtiff$|curl$")


def expect(condition, message):
    if not condition:
        sys.exit(f"FAILED: {message}")


def amiss(what, found, listed):
    """What two lists have not in common, a line each."""
    yield from (f"{what}: {name} is not in THIRD_PARTY.md" for name in sorted(set(found) - set(listed)))
    yield from (f"{what}: THIRD_PARTY.md names {name}, which is not" for name in sorted(set(listed) - set(found)))


def linked(programs):
    """The packages of the libraries that programs name; a library of no package stands there by itself."""
    files = {path for program in programs for path in third_party.linked(program).values()}
    owners = third_party.owners(files)
    return {owners.get(path, str(path)) for path in files}


def loaded(programs):
    """The packages of all libraries that the loader brings in."""
    return set(third_party.owners({path for program in programs for path in third_party.loaded(program).values()}).values())


def with_gpl(packages):
    """Those whose copyright file puts all of them under the GPL, if not said otherwise, and leaves no other choice."""
    licence = {name: third_party.main_licence(third_party.copyright_text(name)) for name in packages}
    return {name for name, text in licence.items() if text.startswith("GPL") and " or " not in text}


def headers():
    """The system's headers that the shipped programs were compiled from, as the compiler told Ninja."""
    told = subprocess.run(["ninja", "-C", str(BUILD), "-t", "deps"], capture_output=True, text=True, check=True).stdout
    blocks = [block for block in told.split("\n\n") if re.match(r"(src|apps)/", block)]
    expect(blocks, f"{BUILD}: Ninja knows of no source of the programs; build them")
    return {pathlib.Path(line.strip()) for block in blocks for line in block.splitlines()[1:] if line.startswith("    /usr/")}


def compiled_in(paths):
    packages = set(third_party.owners(paths).values())
    return {name for name in packages if not TOOLCHAIN.match(name)}


def installed_by_setup():
    """What tools/setup.sh installs to build and run."""
    text = (ROOT / "tools" / "setup.sh").read_text()
    return set(re.search(r"\nPACKAGES=\((.*?)\n\)", text, re.DOTALL).group(1).split())


def complaints(tables, programs):
    every = {name for table in tables.values() for name in table}
    closure, system_headers = loaded(programs), headers()
    in_headers = compiled_in(system_headers)
    yield from amiss("linked", linked(programs), tables["Linked"])
    gpl = with_gpl(closure - set(tables["Linked"]) - set(tables["Linked by those"]))
    yield from (f"linked by libraries, under the GPL: {name} is not in THIRD_PARTY.md" for name in sorted(gpl))
    yield from (f"linked by libraries: THIRD_PARTY.md names {name}, which is not" for name in sorted(set(tables["Linked by those"]) - closure))
    yield from (f"compiled in: {name} is not in THIRD_PARTY.md" for name in sorted(in_headers - every))
    yield from (f"compiled in: no source includes anything of {name}" for name in sorted(set(tables["Compiled in"]) - in_headers))
    yield from (f"tools/setup.sh: {name} is not in THIRD_PARTY.md" for name in sorted(installed_by_setup() - every))
    yield from (f"{name} is loaded, and THIRD_PARTY.md says it is not" for name in closure if name.startswith("libfftw"))
    yield from (f"{path} is compiled in, and THIRD_PARTY.md says it is not" for path in system_headers if path.name.startswith("fftw"))
    for heading, table in tables.items():
        yield from (f"{name}: '{licence}' is no licence as SPDX writes it" for name, (licence, _) in table.items()
                    if heading != "Only for building" and not LICENCE.match(licence))


def check_planted_faults(tables, programs):
    """A package too few, one too many and a licence that is none are found, each by itself."""
    for heading, name in (("Linked", "libpng16-16"), ("Linked by those", "libjbig0"), ("Compiled in", "libglm-dev"),
                          ("Only for building", "libfftw3-dev")):
        fewer = {**tables, heading: {key: facts for key, facts in tables[heading].items() if key != name}}
        found = list(complaints(fewer, programs))
        expect(found and all(f"{name} is not in" in line for line in found), f"{name} was taken out; found: {found}")
    for heading in ("Linked", "Linked by those", "Compiled in"):
        more = {**tables, heading: {**tables[heading], "libnothing1": ("MIT", "")}}
        found = list(complaints(more, programs))
        expect(len(found) == 1 and "libnothing1" in found[0], f"a package was added to '{heading}'; found: {found}")
    wrong = {**tables, "Linked": {**tables["Linked"], "zlib1g": ("like zlib's", "")}}
    found = list(complaints(wrong, programs))
    expect(len(found) == 1 and "like zlib's" in found[0], f"a licence was misspelled; found: {found}")


def main():
    programs = [BUILD / "bin" / name for name in PROGRAMS]
    tables = third_party.declared()
    found = list(complaints(tables, programs))
    expect(not found, "\n".join(found))
    check_planted_faults(tables, programs)
    print(f"passed: {len(tables['Linked'])} packages are linked, {len(loaded(programs))} loaded")


main()
