# SPDX-License-Identifier: Apache-2.0
"""What `cmake --install` and `cpack -G DEB` give: everything a desktop needs, valid, and programs that run from there."""

import argparse
import os
import pathlib
import shutil
import subprocess
import sys
import xml.etree.ElementTree as ElementTree

INSTALLED = ["bin/vstudio", "bin/volume-studio", "libexec/volume-studio/volume-studio-decoder", "share/applications/volume-studio.desktop",
             "share/icons/hicolor/scalable/apps/volume-studio.svg", "share/mime/packages/volume-studio.xml",
             "share/metainfo/org.volumestudio.VolumeStudio.metainfo.xml", "share/doc/volume-studio/LICENSE",
             "share/doc/volume-studio/THIRD_PARTY.md", "share/doc/volume-studio/sbom.cdx.json"]
# What the programs cannot do without, by the beginning of the package's name.
DEPENDS = ["libqt6widgets6", "libqt6svg6", "libinsighttoolkit5", "libepoxy0", "libzstd1", "libc6"]


def need(condition, message):
    if not condition:
        sys.exit(f"FAILED: {message}")


def run(*command, **options):
    done = subprocess.run([str(part) for part in command], capture_output=True, text=True, check=False, **options)
    need(done.returncode == 0, f"{' '.join(map(str, command))} ended with {done.returncode}:\n{done.stdout}{done.stderr}")
    return done.stdout


def check(name, *command):
    """Runs a checker of the desktop's own formats."""
    need(shutil.which(command[0]), f"{name}: not checked, {command[0]} is not installed")
    run(*command)
    print(f"{name}: valid")


def check_install(build, prefix):
    run("cmake", "--install", build, "--prefix", prefix)
    for path in INSTALLED:
        need((prefix / path).is_file(), f"{path} was not installed")
    share = prefix / "share"
    check("desktop entry", "desktop-file-validate", share / "applications/volume-studio.desktop")
    check("AppStream", "appstreamcli", "validate", "--no-net", share / "metainfo/org.volumestudio.VolumeStudio.metainfo.xml")
    for path in ("mime/packages/volume-studio.xml", "icons/hicolor/scalable/apps/volume-studio.svg"):
        ElementTree.parse(share / path)  # or it ends here
    # Nothing of the build or source folder: presets, shaders and translations are in the programs.
    environment = {"PATH": "/usr/bin:/bin", "HOME": str(prefix), "LANG": "de_DE.UTF-8", "LANGUAGE": "de"}
    version = run(prefix / "bin/volume-studio", "--version", env=environment)
    need(version.startswith("volume-studio "), f"--version says '{version}'")
    help_text = run(prefix / "bin/volume-studio", "--help", env=dict(environment, LC_ALL="C.UTF-8"))
    need("Reshape a 3D scan" in help_text or "3D-Scan" in help_text, f"--help says '{help_text}'")
    phantom = prefix / "phantom.nrrd"
    run(prefix / "bin/vstudio", "phantom", "head", "-o", phantom, "--size", "32", env=environment)
    need("32" in run(prefix / "bin/vstudio", "info", phantom, env=environment), "info does not know the phantom's size")
    need("ct_bone" in run(prefix / "bin/vstudio", "render", "--help", env=environment), "the presets are not there")


def check_package(build, folder):
    folder.mkdir()
    run("cpack", "-G", "DEB", "--config", build / "CPackConfig.cmake", "-B", folder, cwd=folder)
    packages = list(folder.glob("*.deb"))
    need(len(packages) == 1, f"cpack made {packages}")
    depends = run("dpkg-deb", "--field", packages[0], "Depends")
    for name in DEPENDS:
        need(name in depends, f"the package does not depend on {name}, but on {depends}")
    need("qt6-translations-l10n" in run("dpkg-deb", "--field", packages[0], "Recommends"), "Qt's own texts are not recommended")
    contents = run("dpkg-deb", "--contents", packages[0])
    for path in INSTALLED:
        need(f" ./usr/{path}\n" in contents, f"the package lacks /usr/{path}")
    paths = [line.split(maxsplit=5)[5] for line in contents.splitlines()]
    need(all(path == "./" or path.startswith("./usr/") for path in paths), f"the package writes elsewhere than /usr: {paths}")
    print(f"{packages[0].name}: {packages[0].stat().st_size // 1024} KiB, depends on {depends.strip()}")


def main(arguments):
    arguments.build, arguments.work = arguments.build.resolve(), arguments.work.resolve()
    shutil.rmtree(arguments.work, ignore_errors=True)
    arguments.work.mkdir(parents=True)
    check_install(arguments.build, arguments.work / "prefix")
    need(shutil.which("dpkg-shlibdeps"), "package: not checked, dpkg-dev is not installed")
    check_package(arguments.build, arguments.work / "package")
    print("passed")


if __name__ == "__main__":
    os.umask(0o022)
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--build", type=pathlib.Path, required=True)
    parser.add_argument("--work", type=pathlib.Path, required=True, help="folder to work in; emptied first")
    main(parser.parse_args())
