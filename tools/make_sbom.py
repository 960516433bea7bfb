#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes what built programs consist of and need, as a software bill of materials: CycloneDX 1.5, JSON.

Components are the Debian packages whose libraries the programs name, with each library's hash, those that are compiled in, and those that
are run or read where they are installed (THIRD_PARTY.md, which has their licences; what Debian's copyright files name stands beside them
as evidence). The same programs and packages give the same bytes: everything is sorted, the serial number is made from the content,
and there is no time in it unless SOURCE_DATE_EPOCH gives one. A file that would stay as it is is not written again.

usage: make_sbom.py --version VERSION --output FILE PROGRAM...
"""
import argparse
import datetime
import hashlib
import json
import os
import pathlib
import sys
import urllib.parse
import uuid

import third_party

NAME = "volume-studio"
SCOPES = {"Compiled in": "required", "Run, loaded or read": "optional"}  # what is linked is asked of the programs
TYPES = {"ffmpeg": "application", "fonts-dejavu-core": "data", "mricron-data": "data", "qt6-translations-l10n": "data"}


def distribution():
    """The names of this system for addresses of packages: what they are kept under, and which release."""
    lines = pathlib.Path("/etc/os-release").read_text().splitlines()
    values = {name: value.strip('"') for name, _, value in (line.partition("=") for line in lines)}
    return values.get("ID", "debian"), "-".join(filter(None, [values.get("ID", "debian"), values.get("VERSION_ID")]))


def package_url(package, version, architecture):
    vendor, release = distribution()
    return (f"pkg:deb/{vendor}/{urllib.parse.quote(package, safe='')}@{urllib.parse.quote(version, safe=':~')}"
            f"?arch={architecture}&distro={urllib.parse.quote(release, safe='')}")


def installed():
    """Version and architecture of all installed packages."""
    rows = third_party.output("dpkg-query", "-W", "-f=${Package}\t${Version}\t${Architecture}\t${db:Status-Status}\n").splitlines()
    fields = [row.split("\t") for row in rows]
    return {name: (version, architecture) for name, version, architecture, status in fields if status == "installed"}


def hashed(path):
    return [{"alg": "SHA-256", "content": hashlib.sha256(path.read_bytes()).hexdigest()}]


def licences(package, declared):
    """The licence that THIRD_PARTY.md has, and as evidence all that Debian's copyright file names."""
    found = {"licenses": [{"expression": declared[package]}]} if declared.get(package) else {}
    named = third_party.licences_in(third_party.copyright_text(package))
    if named:
        found["evidence"] = {"licenses": [{"license": {"name": name}} for name in named]}
    return found


class Bill:
    """The packages and libraries that programs need, as components, and who needs whom."""

    def __init__(self, programs):
        self.programs = sorted(programs)
        self.linked = {program: set(third_party.linked(program).values()) for program in programs}
        self.libraries = sorted(set().union(*self.linked.values()))
        self.owners, self.versions = third_party.owners(self.libraries), installed()
        self.tables = third_party.declared()

    def ref(self, path):
        """What a library is called: its package, or itself where no package has brought it."""
        owner = self.owners.get(path)
        return package_url(owner, *self.versions[owner]) if owner else f"file:{path.name}"

    def scopes(self):
        """The packages that belong in, and whether programs do without them."""
        found = {package: scope for heading, scope in SCOPES.items() for package in self.tables.get(heading, {})}
        found.update({package: "required" for package in self.owners.values()})
        return {package: scope for package, scope in sorted(found.items()) if package in self.versions}

    def package(self, name, scope):
        declared = {package: licence for table in self.tables.values() for package, (licence, _) in table.items()}
        ref = package_url(name, *self.versions[name])
        files = [{"type": "file", "bom-ref": f"{ref}#{path.name}", "name": path.name, "hashes": hashed(path)}
                 for path in self.libraries if self.owners.get(path) == name]
        return {"type": TYPES.get(name, "library"), "bom-ref": ref, "name": name, "version": self.versions[name][0],
                "scope": scope, "purl": ref, **licences(name, declared), **({"components": files} if files else {})}

    def components(self):
        unpackaged = [{"type": "library", "bom-ref": self.ref(path), "name": path.name, "scope": "required", "hashes": hashed(path)}
                      for path in self.libraries if path not in self.owners]
        return [self.package(name, scope) for name, scope in self.scopes().items()] + unpackaged

    def dependencies(self):
        """Each program needs what it names; the whole needs its programs, and what no program names."""
        needs = [{"ref": f"{NAME}/{program.name}", "dependsOn": sorted({self.ref(path) for path in self.linked[program]})}
                 for program in self.programs]
        named = {ref for need in needs for ref in need["dependsOn"]}
        others = [one["bom-ref"] for one in self.components() if one["bom-ref"] not in named]
        return [{"ref": NAME, "dependsOn": sorted([need["ref"] for need in needs] + others)}, *needs]

    def program(self, version):
        return {"type": "application", "bom-ref": NAME, "name": NAME, "version": version, "licenses": [{"expression": "Apache-2.0"}],
                "components": [{"type": "application", "bom-ref": f"{NAME}/{program.name}", "name": program.name, "version": version}
                               for program in self.programs]}


def document(version, programs):
    bill = Bill(programs)
    content = {"bomFormat": "CycloneDX", "specVersion": "1.5", "version": 1, "metadata": {"component": bill.program(version)},
               "components": bill.components(), "dependencies": bill.dependencies()}
    epoch = os.environ.get("SOURCE_DATE_EPOCH")
    if epoch:
        moment = datetime.datetime.fromtimestamp(int(epoch), datetime.timezone.utc)
        content["metadata"]["timestamp"] = moment.strftime("%Y-%m-%dT%H:%M:%SZ")
    serial = uuid.uuid5(uuid.NAMESPACE_URL, json.dumps(content, sort_keys=True))
    return {"$schema": "http://cyclonedx.org/schema/bom-1.5.schema.json", "serialNumber": f"urn:uuid:{serial}", **content}


def write(path, made):
    text = json.dumps(made, indent=1, sort_keys=True, ensure_ascii=False) + "\n"
    if not path.is_file() or path.read_text() != text:
        path.write_text(text)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--version", required=True)
    parser.add_argument("--output", type=pathlib.Path, required=True)
    parser.add_argument("programs", nargs="+", type=pathlib.Path)
    arguments = parser.parse_args()
    write(arguments.output, document(arguments.version, arguments.programs))
    return 0


if __name__ == "__main__":
    sys.exit(main())
