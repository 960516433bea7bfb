# SPDX-License-Identifier: Apache-2.0
"""Reads the voxels of NRRD and NIfTI files as a numpy array indexed [z, y, x]; where they lie, `vstudio info` says."""
import gzip

import numpy as np

NRRD_TYPES = {"int8": "i1", "signed char": "i1", "uint8": "u1", "unsigned char": "u1", "uchar": "u1",
              "int16": "i2", "short": "i2", "uint16": "u2", "unsigned short": "u2", "ushort": "u2",
              "int32": "i4", "int": "i4", "uint32": "u4", "float": "f4", "double": "f8"}
NIFTI_TYPES = {2: "u1", 4: "i2", 8: "i4", 16: "f4", 64: "f8", 256: "i1", 512: "u2", 768: "u4"}


class UnknownFile(Exception):
    """The file is of a kind that is not read here."""


def read_nrrd(path):
    with open(path, "rb") as file:
        fields = {}
        if not file.readline().startswith(b"NRRD"):
            raise UnknownFile(f"{path}: not an NRRD file")
        while (line := file.readline().decode("ascii").strip()):
            key, colon, value = line.partition(":")
            if colon and not line.startswith("#"):
                fields[key.strip()] = value.strip()
        body = file.read()
    if fields.get("encoding") in ("gzip", "gz"):
        body = gzip.decompress(body)
    elif fields.get("encoding") != "raw":
        raise UnknownFile(f"{path}: NRRD encoding {fields.get('encoding')} is not read here")
    if "data file" in fields or fields["type"] not in NRRD_TYPES:
        raise UnknownFile(f"{path}: detached NRRD or type {fields['type']} is not read here")
    order = ">" if fields.get("endian") == "big" else "<"
    shape = [int(n) for n in fields["sizes"].split()][::-1]
    return np.frombuffer(body, order + NRRD_TYPES[fields["type"]], int(np.prod(shape))).reshape(shape)


def read_nifti(path):
    with (gzip.open if str(path).endswith(".gz") else open)(path, "rb") as file:
        data = file.read()
    order = "<" if data[:4] == b"\x5c\x01\x00\x00" else ">"

    def header(kind, offset, count=1):
        return np.frombuffer(data, order + kind, count, offset)

    code = int(header("i2", 70)[0])
    if int(header("i4", 0)[0]) != 348 or code not in NIFTI_TYPES:
        raise UnknownFile(f"{path}: not a NIfTI-1 file of a known type")
    shape = [int(n) for n in header("i2", 42, 3)][::-1]
    values = header(NIFTI_TYPES[code], int(header("f4", 108)[0]), int(np.prod(shape))).reshape(shape)
    slope, intercept = (float(header("f4", offset)[0]) for offset in (112, 116))
    if slope in (0, 1) and intercept == 0:
        return values
    return (values * slope + intercept).astype("f4")


def read(path):
    """Native byte order, contiguous."""
    values = read_nrrd(path) if str(path).endswith(".nrrd") else read_nifti(path)
    return np.ascontiguousarray(values, values.dtype.newbyteorder("="))
