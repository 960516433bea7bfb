# SPDX-License-Identifier: Apache-2.0
"""The bill of materials says what CycloneDX 1.5 wants it to say, of the programs as they were built, and the same each time.

The rules of the format that apply to it are written down here (`FIELDS`, `complaints`); each is tried on a planted fault.

usage: test_sbom.py ROOT BUILD VERSION
"""
import copy
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT, BUILD = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
VERSION = sys.argv[3]
sys.path.insert(0, str(ROOT / "tools"))
import third_party  # noqa: E402

PROGRAMS = ["vstudio", "volume-studio", "volume-studio-decoder"]
TYPES = {"application", "framework", "library", "container", "platform", "operating-system", "device", "device-driver", "firmware",
         "file", "machine-learning-model", "data"}
SERIAL = r"urn:uuid:[0-9a-f]{8}-[0-9a-f]{4}-[0-9a-f]{4}-[0-9a-f]{4}-[0-9a-f]{12}"
TIME = r"\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ"
# The members that objects of a kind may have here, each a type or a pattern; those with a ! must be there.
FIELDS = {
    "bill": {"$schema": str, "bomFormat!": "CycloneDX", "specVersion!": r"1\.5", "serialNumber": SERIAL, "version": int, "metadata": dict,
             "components": list, "dependencies": list},
    "metadata": {"timestamp": TIME, "component": dict},
    "component": {"type!": "|".join(TYPES), "name!": ".+", "version": ".+", "bom-ref": ".+", "scope": "required|optional|excluded",
                  "purl": r"pkg:deb/[a-z]+/[a-z0-9.%A-F-]+@[\w.~:%-]+\?arch=\w+&distro=[\w.%-]+", "hashes": list, "licenses": list,
                  "evidence": dict, "components": list},
    "hash": {"alg!": "SHA-256", "content!": "[0-9a-f]{64}"},
    "dependency": {"ref!": ".+", "dependsOn": list},
    "evidence": {"licenses": list},
}


def expect(condition, message):
    if not condition:
        sys.exit(f"FAILED: {message}")


def is_right(value, rule):
    if isinstance(rule, str):
        return isinstance(value, str) and re.fullmatch(rule, value) is not None
    return isinstance(value, rule) and not isinstance(value, bool)


def wrong_members(kind, value, place):
    """What an object of a kind lacks, has too much, or has wrong."""
    rules = {name.rstrip("!"): rule for name, rule in FIELDS[kind].items()}
    needed = {name.rstrip("!") for name in FIELDS[kind] if name.endswith("!")}
    yield from (f"{place}: lacks {name}" for name in sorted(needed - value.keys()))
    yield from (f"{place}: {name} does not belong there" for name in sorted(value.keys() - rules.keys()))
    yield from (f"{place}: {name} is wrong: {value[name]!r}" for name, rule in rules.items() if name in value and not is_right(value[name], rule))


def wrong_licences(choices, place):
    """Either one expression, or licences that have a name or SPDX's id."""
    expressions = [one for one in choices if "expression" in one]
    if expressions and len(choices) > 1:
        yield f"{place}: an expression stands alone"
    for one in choices:
        licence = one.get("license", {})
        if not ("expression" in one or ("name" in licence) != ("id" in licence)):
            yield f"{place}: a licence needs an expression, a name or an id: {one}"


def wrong_component(component, place):
    yield from wrong_members("component", component, place)
    for hashed in component.get("hashes", []):
        yield from wrong_members("hash", hashed, f"{place}: hash")
    yield from wrong_licences(component.get("licenses", []), place)
    if "evidence" in component:
        yield from wrong_members("evidence", component["evidence"], place)
        yield from wrong_licences(component["evidence"].get("licenses", []), place)
    for inner in component.get("components", []):
        yield from wrong_component(inner, f"{place}/{inner.get('name')}")


def references(component):
    yield component.get("bom-ref")
    for inner in component.get("components", []):
        yield from references(inner)


def wrong_references(bill):
    """References are given once each; dependencies go from and to such, with one entry for each."""
    everything = [bill["metadata"]["component"], *bill["components"]]
    given = [ref for component in everything for ref in references(component)]
    yield from (f"{ref} is given twice" for ref in sorted({ref for ref in given if given.count(ref) > 1}, key=str))
    starts = [need["ref"] for need in bill["dependencies"]]
    yield from (f"{ref} has two lists of dependencies" for ref in sorted({ref for ref in starts if starts.count(ref) > 1}))
    ends = [ref for need in bill["dependencies"] for ref in need.get("dependsOn", [])]
    yield from (f"dependencies name {ref}, which nothing is called" for ref in sorted(set(starts + ends) - set(given)))
    yield from (f"{need['ref']} needs something twice" for need in bill["dependencies"]
                if len(need.get("dependsOn", [])) != len(set(need.get("dependsOn", []))))


def complaints(bill):
    yield from wrong_members("bill", bill, "bill")
    yield from wrong_members("metadata", bill["metadata"], "metadata")
    for component in [bill["metadata"]["component"], *bill["components"]]:
        yield from wrong_component(component, component.get("name"))
    for need in bill["dependencies"]:
        yield from wrong_members("dependency", need, "dependency")
    yield from wrong_references(bill)


def check_planted_faults(good):
    library = next(i for i, one in enumerate(good["components"]) if one.get("components"))
    plants = [
        (lambda bill: bill.pop("bomFormat"), "lacks bomFormat"),
        (lambda bill: bill.update(specVersion="1.9"), "specVersion is wrong"),
        (lambda bill: bill.update(serialNumber="17"), "serialNumber is wrong"),
        (lambda bill: bill.update(version=True), "version is wrong"),
        (lambda bill: bill["metadata"].update(timestamp="today"), "timestamp is wrong"),
        (lambda bill: bill["components"][library].pop("type"), "lacks type"),
        (lambda bill: bill["components"][library].update(size=3), "size does not belong there"),
        (lambda bill: bill["components"][library].update(purl="pkg:deb/zlib"), "purl is wrong"),
        (lambda bill: bill["components"][library]["components"][0]["hashes"][0].update(content="12"), "content is wrong"),
        (lambda bill: bill["components"][library].update(licenses=[{"expression": "MIT"}, {"license": {"id": "MIT"}}]), "stands alone"),
        (lambda bill: bill["components"][library].update(licenses=[{"license": {}}]), "a licence needs"),
        (lambda bill: bill["components"].append(copy.deepcopy(bill["components"][library])), "is given twice"),
        (lambda bill: bill["dependencies"].append({"ref": "nobody"}), "which nothing is called"),
        (lambda bill: bill["dependencies"].append(copy.deepcopy(bill["dependencies"][0])), "two lists"),
        (lambda bill: bill["dependencies"][0]["dependsOn"].append(bill["dependencies"][0]["dependsOn"][0]), "something twice"),
    ]
    for plant, what in plants:
        bill = copy.deepcopy(good)
        plant(bill)
        found = list(complaints(bill))
        expect(any(what in line for line in found), f"a fault was planted that is '{what}'; found: {found}")


def make(folder, **variables):
    """The bill, made anew: its bytes."""
    path = pathlib.Path(folder) / "bill.json"
    environment = {name: value for name, value in os.environ.items() if name != "SOURCE_DATE_EPOCH"}
    programs = [BUILD / "bin" / name for name in (reversed(PROGRAMS) if variables else PROGRAMS)]
    subprocess.run([sys.executable, ROOT / "tools" / "make_sbom.py", "--version", VERSION, "--output", path, *programs],
                   env={**environment, **variables}, check=True)
    return path.read_bytes()


def check_repeats(bill):
    """The bill of the build is what is made now, in another language too; a time stands in it only where one is given."""
    with tempfile.TemporaryDirectory() as folder:
        again = make(folder)
        expect(json.loads(again) == bill, "the bill of the build is not what is made of its programs now; build the target sbom")
        expect(make(folder, LC_ALL="C", LANG="de_DE.UTF-8", TZ="Asia/Tokyo") == again, "two bills of the same programs differ")
        timed = json.loads(make(folder, SOURCE_DATE_EPOCH="86400"))
    expect(timed["metadata"].get("timestamp") == "1970-01-02T00:00:00Z", f"SOURCE_DATE_EPOCH: {timed['metadata']}")
    expect("timestamp" not in bill["metadata"], "a time stands in the bill that nobody gave")
    expect(timed["serialNumber"] != bill["serialNumber"], "two bills that differ have one serial number")


def check_content(bill):
    """Each program with the packages that it links; what is compiled in, run and read; licences of all."""
    main = bill["metadata"]["component"]
    expect((main["name"], main["version"]) == ("volume-studio", VERSION), f"the bill is of {main['name']} {main['version']}")
    needs = {need["ref"]: need["dependsOn"] for need in bill["dependencies"]}
    by_ref = {one["bom-ref"]: one for one in bill["components"]}
    for name in PROGRAMS:
        files = third_party.linked(BUILD / "bin" / name)
        wanted = set(third_party.owners(files.values()).values())
        found = {by_ref[ref]["name"] for ref in needs[f"volume-studio/{name}"]}
        expect(wanted and wanted == found, f"{name} links {sorted(wanted)}, the bill says {sorted(found)}")
    names = {one["name"] for one in bill["components"]}
    missing = {"libinsighttoolkit5-dev", "libglm-dev", "libcli11-dev", "nlohmann-json3-dev", "ffmpeg", "fonts-dejavu-core"} - names
    expect(not missing, f"the bill lacks {missing}")
    without = [one["name"] for one in bill["components"] if not one.get("licenses")]
    expect(not without, f"no licence is said of {without}")


def main():
    path = BUILD / "sbom.cdx.json"
    expect(path.is_file(), f"{path} was not made; build the target sbom")
    bill = json.loads(path.read_text())
    found = list(complaints(bill))
    expect(not found, "\n".join(found))
    check_planted_faults(bill)
    check_content(bill)
    check_repeats(bill)
    print(f"passed: {len(bill['components'])} components, {path.stat().st_size} bytes")


main()
