#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Reads volumes by other people's libraries: nibabel, pydicom, VTK's own readers and teem's unu.

Lines "FORMAT<tab>PATH<tab>OUT" on standard input; for each a line of JSON: shape (z, y, x), the affine (LPS mm, 3 x 4) where
the library knows it, and the values as float64 in OUT; or why it could not. A process of its own, since these crash, too.
"""
import json
import os
import re
import resource
import signal
import subprocess
import sys
import tempfile
import warnings
import zlib

import nibabel
import numpy
import pydicom

warnings.simplefilter("ignore")
SECONDS = 10
BYTES = 4 << 30
LPS = numpy.diag([-1.0, -1.0, 1.0, 1.0])


def nifti(path):
    image = nibabel.load(path)
    values = numpy.asanyarray(image.dataobj)
    while values.ndim > 3 and values.shape[-1] == 1:
        values = values[..., 0]
    if values.ndim < 3:
        values = values.reshape(values.shape + (1,) * (3 - values.ndim))
    header = image.header
    placed = int(header["sform_code"]) > 0 or int(header["qform_code"]) > 0
    units = {1: 1000.0, 2: 1.0, 3: 0.001}.get(int(header["xyzt_units"]) & 7, 1.0)
    scale = numpy.diag([units, units, units, 1.0])
    return values.T, (LPS @ scale @ image.affine)[:3] if placed else None


def dicom(path):
    """A file, or a folder of slices that lie one behind the other."""
    paths = [os.path.join(path, name) for name in sorted(os.listdir(path))] if os.path.isdir(path) else [path]
    slices = []
    for one in paths:
        try:
            data = pydicom.dcmread(one)
        except pydicom.errors.InvalidDicomError:
            if len(paths) == 1:
                raise
            continue  # other files lie in folders of slices, too
        slope = float(getattr(data, "RescaleSlope", 1) or 1)
        intercept = float(getattr(data, "RescaleIntercept", 0) or 0)
        # Bits that are not stored mean nothing (PS3.5, 8.1.1); pydicom takes them for part of the value.
        half = 2.0 ** (data.BitsStored - 1) if data.PixelRepresentation == 1 else 0.0
        stored = (data.pixel_array.astype(numpy.float64) + half) % 2.0 ** data.BitsStored - half
        values = stored * slope + intercept
        slices.append((data, values))
    data = slices[0][0]
    rows = numpy.array(data.ImageOrientationPatient[:3], float), numpy.array(data.ImageOrientationPatient[3:], float)
    normal = numpy.cross(*rows)
    slices.sort(key=lambda entry: numpy.dot(normal, numpy.array(entry[0].ImagePositionPatient, float)))
    places = [numpy.array(data.ImagePositionPatient, float) for data, _ in slices]
    spacing = [float(s) for s in data.PixelSpacing]
    affine = numpy.zeros((3, 4))
    affine[:, 0] = rows[0] * spacing[1]
    affine[:, 1] = rows[1] * spacing[0]
    affine[:, 2] = (places[-1] - places[0]) / (len(places) - 1) if len(places) > 1 else normal
    affine[:, 3] = places[0]
    if len(slices) == 1:
        values = slices[0][1]
        return (values if values.ndim == 3 else values[None]), None
    return numpy.stack([values for _, values in slices]), affine


def by_vtk(reader):
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkCommonCore import vtkObject
    vtkObject.GlobalWarningDisplayOff()
    failed = []
    reader.AddObserver("ErrorEvent", lambda *_: failed.append(1))
    reader.Update()
    image = reader.GetOutput()
    scalars = image.GetPointData().GetScalars()
    if failed or scalars is None or scalars.GetNumberOfComponents() != 1:
        raise ValueError("VTK has no scalars of it")
    dims = image.GetDimensions()
    return vtk_to_numpy(scalars).reshape(dims[::-1]), image


def has_nan_in_text(path):
    """VTK stops at the first of them, and leaves what is behind as it finds it."""
    folder = os.path.dirname(path)  # values may lie in a file beside the header
    contents = [read(os.path.join(folder, name)) for name in os.listdir(folder) if os.path.isfile(os.path.join(folder, name))]
    is_text = any(re.search(rb"BinaryData = [Ff0]|\nASCII", content[:2000]) for content in contents)
    return is_text and any(re.search(rb"\b(nan|inf)", content, re.I) for content in contents)


def read(path):
    with open(path, "rb") as file:
        return file.read()


def vtk_legacy(path):
    if has_nan_in_text(path):
        header, text = read(path).split(b"LOOKUP_TABLE default\n", 1)
        dims = [int(n) for n in re.search(rb"\nDIMENSIONS (.*)", header)[1].split()]
        return numpy.array([float(word) for word in text.split()]).reshape(dims[::-1]), None
    from vtkmodules.vtkIOLegacy import vtkStructuredPointsReader
    reader = vtkStructuredPointsReader()
    reader.SetFileName(path)
    values, image = by_vtk(reader)
    affine = numpy.zeros((3, 4))
    affine[:, :3] = numpy.diag(image.GetSpacing())
    affine[:, 3] = image.GetOrigin()
    return values, affine


MET_TYPES = {"MET_CHAR": "i1", "MET_UCHAR": "u1", "MET_SHORT": "i2", "MET_USHORT": "u2", "MET_INT": "i4", "MET_UINT": "u4",
             "MET_FLOAT": "f4", "MET_DOUBLE": "f8"}


def meta_by_hand(path, header, values):
    """What MetaIO does not read rightly: texts with nan, and deflated values whose number of bytes is not stated, which it
    takes for the values."""
    fields = dict(re.findall(r"^(\w+) = (.*?)\s*$", header.decode("latin-1"), re.M))
    if fields["ElementDataFile"] != "LOCAL":
        values = read(os.path.join(os.path.dirname(path), fields["ElementDataFile"]))
    shape = [int(n) for n in fields["DimSize"].split()][::-1]
    if fields["BinaryData"] == "False":
        return numpy.array([float(word) for word in values.split()]).reshape(shape), None
    order = ">" if fields["BinaryDataByteOrderMSB"] == "True" else "<"
    return numpy.frombuffer(zlib.decompress(values), order + MET_TYPES[fields["ElementType"]]).reshape(shape), None


def meta(path):
    header, line, values = re.split(rb"(ElementDataFile = [^\n]*\n)", read(path), maxsplit=1)
    header += line
    states_no_size = b"CompressedData = True" in header and not re.search(rb"^CompressedDataSize = [1-9]", header, re.M)
    if states_no_size or has_nan_in_text(path):
        return meta_by_hand(path, header, values)
    from vtkmodules.vtkIOImage import vtkMetaImageReader
    reader = vtkMetaImageReader()
    reader.SetFileName(path)
    if not reader.CanReadFile(path):
        raise ValueError("VTK does not take it for a MetaImage")
    values, image = by_vtk(reader)
    affine = numpy.full((3, 4), numpy.nan)  # it leaves the axes alone
    affine[:, 3] = image.GetOrigin()
    return values, affine


UNU_TYPES = {"signed char": "i1", "unsigned char": "u1", "short": "<i2", "unsigned short": "<u2", "int": "<i4",
             "unsigned int": "<u4", "long long int": "<i8", "unsigned long long int": "<u8", "float": "<f4", "double": "<f8"}


def nrrd(path):
    """By unu, the program of those who made the format."""
    with tempfile.TemporaryDirectory() as folder:
        plain = os.path.join(folder, "plain.nrrd")
        subprocess.run(["teem-unu", "save", "-f", "nrrd", "-e", "raw", "-en", "little", "-i", path, "-o", plain], check=True,
                       capture_output=True, timeout=SECONDS)
        with open(plain, "rb") as file:
            header, data = file.read().split(b"\n\n", 1)
    fields = dict(line.split(": ", 1) for line in header.decode().splitlines() if ": " in line and line[0] != "#")
    sizes = [int(size) for size in fields["sizes"].split()]
    values = numpy.frombuffer(data, UNU_TYPES[fields["type"]]).reshape(sizes[::-1])
    while values.ndim > 3 and values.shape[0] == 1:
        values = values[0]
    return values, nrrd_place(fields)


def nrrd_place(fields):
    """Where it lies, where the header says it for patients."""
    signs = {"left-posterior-superior": (1, 1, 1), "right-anterior-superior": (-1, -1, 1)}.get(fields.get("space"))
    if signs is None or "space directions" not in fields or "none" in fields["space directions"]:
        return None
    vectors = [[float(number) for number in vector.strip("()").split(",")] for vector in fields["space directions"].split()]
    origin = [float(number) for number in fields.get("space origin", "(0,0,0)").strip("()").split(",")]
    return numpy.diag(signs) @ numpy.array(vectors + [origin]).T


READERS = {"nifti": nifti, "dicom": dicom, "vtk": vtk_legacy, "meta": meta, "nrrd": nrrd}


def too_slow(*_):
    raise TimeoutError("took too long")


def main():
    resource.setrlimit(resource.RLIMIT_AS, (BYTES, BYTES))
    signal.signal(signal.SIGALRM, too_slow)
    answers = os.fdopen(os.dup(1), "w")  # libraries print
    os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
    os.dup2(1, 2)
    for line in sys.stdin:
        form, path, out = line.rstrip("\n").split("\t")
        signal.alarm(SECONDS)
        try:
            values, affine = READERS[form](path)
            values = numpy.ascontiguousarray(values, dtype=numpy.float64)
            values.tofile(out)
            answer = {"shape": values.shape, "affine": None if affine is None else affine.ravel().tolist()}
        except BaseException as error:  # any of them: it has no opinion then
            answer = {"failed": f"{type(error).__name__}: {error}"[:300]}
        signal.alarm(0)
        print(json.dumps(answer), file=answers, flush=True)


if __name__ == "__main__":
    main()
