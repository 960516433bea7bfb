# SPDX-License-Identifier: Apache-2.0
"""Small scans in every form that each format allows, made from a random generator: what they hold does not matter, only that
two readers find the same."""
import gzip
import io
import struct
import zlib

import numpy

TYPES = ["u1", "i1", "u2", "i2", "u4", "i4", "i8", "u8", "f4", "f8"]


class Case:
    """Files of a scan by name, the format's name and which of them is to be opened (a folder: None)."""

    def __init__(self, form, main, files):
        self.form = form
        self.main = main
        self.files = files


def some_dims(random):
    return [random.choice([1, 2, 3, 5, 8, 11]) for _ in range(3)]


def some_values(random, kind, dims, special=True):
    """Values of a numpy kind ("i2"), z slowest: all that the type holds, or small ones."""
    generator = numpy.random.default_rng(random.getrandbits(32))
    count = dims[0] * dims[1] * dims[2]
    dtype = numpy.dtype(kind)
    if dtype.kind == "f":
        values = generator.normal(0, random.choice([1, 1000, 1e-6, 1e6]), count).astype(dtype)
        if special and random.random() < 0.3:
            for value in (numpy.nan, numpy.inf, -numpy.inf, 1e30):
                values[generator.integers(count)] = value
    elif dtype.itemsize == 8:
        values = generator.integers(-(1 << 30) if dtype.kind == "i" else 0, 1 << 30, count).astype(dtype)
    else:
        info = numpy.iinfo(dtype)
        lo, hi = random.choice([(info.min, info.max), (max(info.min, -100), min(info.max, 100))])
        values = generator.integers(lo, hi, count, endpoint=True).astype(dtype)
    return values.reshape(dims[::-1])


def number(random, value):
    """A number as text, in one of the ways in which people write it."""
    return random.choice([repr(float(value)), f"{value:g}", f"{value:.6f}", f"{value:e}"])


def rotation(random):
    """Three orthogonal axes: the grid's, some of them turned round, or any."""
    if random.random() < 0.5:
        axes = numpy.eye(3)[random.sample(range(3), 3)]
        return axes * numpy.array([[random.choice([1, -1])] for _ in range(3)])
    q, _ = numpy.linalg.qr(numpy.random.default_rng(random.getrandbits(32)).normal(size=(3, 3)))
    return q


def spacing(random):
    return [random.choice([1.0, 0.5, 0.75, 2.5, 0.33333334, random.uniform(0.1, 5)]) for _ in range(3)]


# --- NIfTI -----------------------------------------------------------------------------------------------------------------

NIFTI_CODES = {"u1": 2, "i2": 4, "i4": 8, "f4": 16, "f8": 64, "i1": 256, "u2": 512, "u4": 768, "i8": 1024, "u8": 1280}


def nifti(random):
    kind = random.choice(list(NIFTI_CODES))
    dims = some_dims(random)
    order = random.choice("<>")
    values = some_values(random, kind, dims)
    slope, inter = random.choice([(0, 0), (1, 0), (0, 5), (2, 0), (0.5, -10), (-1, 3), (float("nan"), 0), (1, 0.25)])
    extra = random.choice([0, 0, 16, 160])
    offset = 352 + extra
    pixdim = [random.choice([1, -1, 0])] + spacing(random) + [1] * 4
    quatern = numpy.random.default_rng(random.getrandbits(32)).uniform(-0.55, 0.55, 3)
    s = rotation(random) * numpy.array(spacing(random))  # the two forms need not agree
    place = [random.uniform(-200, 200) for _ in range(3)]
    rank = random.choice([3, 3, 3, 4, 5])
    header = struct.pack(
        order + "i10s18sihbB8h3fhhhh8f3fhBB4f2i80s24shh6f4f4f4f16s4s", 348, b"", b"", 0, 0, ord("r"), 0, rank, *dims, 1, 1, 1, 1,
        0, 0, 0, 0, NIFTI_CODES[kind], numpy.dtype(kind).itemsize * 8, 0, *pixdim, offset, slope, inter, 0, 0,
        random.choice([0, 1, 2, 3, 2, 10, 18]), 0, 0, 0, 0, 0, 0, b"a description", b"", random.choice([0, 1, 2, 4]),
        random.choice([0, 0, 1, 3]), *quatern, *place, *s[0], place[0], *s[1], place[1], *s[2], place[2], b"name", b"n+1\0")
    assert len(header) == 348
    data = values.astype(order + kind).tobytes()
    extension = struct.pack(order + "ii", extra, 6) + b"c" * (extra - 8) if extra else b""
    form = random.choice(["nii", "nii.gz", "nii.gz", "img"])
    if form == "img":
        head = bytearray(header)
        head[344:348] = b"ni1\0"
        head[108:112] = struct.pack(order + "f", 0)
        return Case("nifti", "scan.hdr", {"scan.hdr": bytes(head), "scan.img": data})
    body = header + struct.pack("4b", 1 if extra else 0, 0, 0, 0) + extension + data
    return Case("nifti", "scan." + form, {"scan." + form: gzip.compress(body, 6) if form == "nii.gz" else body})


# --- NRRD ------------------------------------------------------------------------------------------------------------------

NRRD_NAMES = {
    "i1": ["signed char", "int8", "int8_t"], "u1": ["uchar", "unsigned char", "uint8", "uint8_t"],
    "i2": ["short", "short int", "signed short", "int16", "int16_t"], "u2": ["ushort", "unsigned short", "uint16", "uint16_t"],
    "i4": ["int", "signed int", "int32", "int32_t"], "u4": ["uint", "unsigned int", "uint32", "uint32_t"],
    "f4": ["float"], "f8": ["double"]}


def ascii_of(random, values):
    flat = values.ravel()
    if flat.dtype.kind == "f":
        words = [random.choice(["nan", "NaN"]) if numpy.isnan(v) else repr(float(v)) for v in flat]
    else:
        words = [str(int(v)) for v in flat]
    return random.choice([" ", "\n", "  ", "\t"]).join(words).encode() + b"\n"


def nrrd(random):
    kind = random.choice(list(NRRD_NAMES))
    dims = some_dims(random)
    values = some_values(random, kind, dims)
    order = random.choice("<>")
    encoding = random.choice(["raw", "raw", "gzip", "gz", "ascii", "txt", "text"])
    lines = [f"NRRD000{random.choice('12345')}", "# made for a test"] if random.random() < 0.5 else ["NRRD0004"]
    fields = [f"type: {random.choice(NRRD_NAMES[kind])}", f"sizes: {' '.join(map(str, dims))}", f"encoding: {encoding}"]
    if encoding in ("raw", "gzip", "gz"):
        fields.append("endian: " + ("little" if order == "<" else "big"))
    space = None
    if random.random() < 0.5 and lines[0] >= "NRRD0004":
        axes = rotation(random) * numpy.array(spacing(random))[:, None]
        space = "space: " + random.choice(["left-posterior-superior", "LPS", "RAS", "right-anterior-superior"])
        fields.append("space directions: " + " ".join("(" + ",".join(number(random, v) for v in axis) + ")" for axis in axes))
        fields.append("space origin: (" + ",".join(number(random, random.uniform(-99, 99)) for _ in range(3)) + ")")
    elif random.random() < 0.7:
        fields.append("spacings: " + " ".join(number(random, v) for v in spacing(random)))
    if random.random() < 0.3:
        fields.append("kinds: domain domain domain")
    if random.random() < 0.2:
        fields.append("content: a test: with a colon")
    random.shuffle(fields)
    fields = ["dimension: 3", *([space] if space else []), *fields]  # must come before what is said of each axis
    if encoding in ("ascii", "txt", "text"):
        data = ascii_of(random, values)
    else:
        data = values.astype(order + kind).tobytes()
    if encoding in ("gzip", "gz"):
        data = gzip.compress(data)
    newline = random.choice(["\n", "\n", "\r\n"])
    detached = random.random() < 0.3
    if detached:
        fields.append("data file: values.bin")
    header = (newline.join(lines + fields) + newline).encode()
    if detached:
        return Case("nrrd", "scan.nhdr", {"scan.nhdr": header, "values.bin": data})
    return Case("nrrd", "scan.nrrd", {"scan.nrrd": header + newline.encode() + data})


# --- MetaImage -------------------------------------------------------------------------------------------------------------

META_NAMES = {"i1": "MET_CHAR", "u1": "MET_UCHAR", "i2": "MET_SHORT", "u2": "MET_USHORT", "i4": "MET_INT", "u4": "MET_UINT",
              "f4": "MET_FLOAT", "f8": "MET_DOUBLE"}


def meta(random):
    kind = random.choice(list(META_NAMES))
    dims = some_dims(random)
    big = random.random() < 0.4
    form = random.choice(["raw", "raw", "zlib", "ascii"])
    values = some_values(random, kind, dims, special=form != "ascii")  # VTK stops at the first nan of a text
    local = random.random() < 0.5
    lines = ["ObjectType = Image", "NDims = 3"]
    if form == "ascii":
        data = ascii_of(random, values)
        lines.append("BinaryData = False")
    else:
        data = values.astype((">" if big else "<") + kind).tobytes()
        lines += ["BinaryData = True", f"{random.choice(['BinaryDataByteOrderMSB', 'ElementByteOrderMSB'])} = {big}"]
    if form == "zlib":
        data = zlib.compress(data)
        lines += ["CompressedData = True", f"CompressedDataSize = {len(data)}"]
    if random.random() < 0.6:
        lines.append("TransformMatrix = " + " ".join(f"{v:.9g}" for v in rotation(random).ravel()))
    if random.random() < 0.7:
        lines.append(random.choice(["Offset", "Position", "Origin"]) + " = " +
                     " ".join(number(random, random.uniform(-99, 99)) for _ in range(3)))
    if random.random() < 0.8:
        lines.append("ElementSpacing = " + " ".join(number(random, v) for v in spacing(random)))
    if random.random() < 0.3:
        lines.append("AnatomicalOrientation = RAI")
    lines.append("DimSize = " + " ".join(map(str, dims)))
    if random.random() < 0.2:
        lines.append("ElementNumberOfChannels = 1")
    lines += [f"ElementType = {META_NAMES[kind]}", "ElementDataFile = " + ("LOCAL" if local else "values.raw")]
    newline = random.choice(["\n", "\n", "\r\n"])
    header = (newline.join(lines) + newline).encode()
    if local:
        return Case("meta", "scan.mha", {"scan.mha": header + data})
    return Case("meta", "scan.mhd", {"scan.mhd": header, "values.raw": data})


# --- VTK legacy ------------------------------------------------------------------------------------------------------------

VTK_NAMES = {"i1": "char", "u1": "unsigned_char", "i2": "short", "u2": "unsigned_short", "i4": "int", "u4": "unsigned_int",
             "f4": "float", "f8": "double"}


def vtk(random):
    kind = random.choice(list(VTK_NAMES))
    dims = some_dims(random)
    binary = random.random() < 0.6
    values = some_values(random, kind, dims, special=binary)
    lines = [f"# vtk DataFile Version {random.choice(['2.0', '3.0', '4.2'])}", "a test", "BINARY" if binary else "ASCII",
             "DATASET STRUCTURED_POINTS"]
    middle = ["DIMENSIONS " + " ".join(map(str, dims)),
              random.choice(["SPACING ", "ASPECT_RATIO "]) + " ".join(number(random, v) for v in spacing(random)),
              "ORIGIN " + " ".join(number(random, random.uniform(-99, 99)) for _ in range(3))]
    random.shuffle(middle)
    lines += middle
    lines += [f"POINT_DATA {values.size}", f"SCALARS values {VTK_NAMES[kind]}{random.choice(['', ' 1'])}", "LOOKUP_TABLE default"]
    data = values.astype(">" + kind).tobytes() if binary else ascii_of(random, values)
    return Case("vtk", "scan.vtk", {"scan.vtk": "\n".join(lines).encode() + b"\n" + data + b"\n"})


# --- DICOM -----------------------------------------------------------------------------------------------------------------

def dicom(random):
    import pydicom
    from pydicom import uid
    syntax = random.choice([uid.ExplicitVRLittleEndian, uid.ImplicitVRLittleEndian, uid.ExplicitVRBigEndian,
                            uid.DeflatedExplicitVRLittleEndian, uid.RLELossless])
    stored, signed = random.choice([(8, 0), (12, 0), (16, 0), (16, 1), (12, 1)])
    rows, columns, count = random.choice([4, 7, 10]), random.choice([4, 6, 9]), random.choice([1, 2, 4])
    lo, hi = (-(1 << (stored - 1)), (1 << (stored - 1)) - 1) if signed else (0, (1 << stored) - 1)
    generator = numpy.random.default_rng(random.getrandbits(32))
    axes = rotation(random)
    step, pixel = random.uniform(0.5, 4), [random.choice([0.5, 0.75, 1.0]), random.choice([0.5, 0.8, 1.0])]
    rescale = random.choice([None, (1, 0), (1, -1024), (2, 5), (0.5, -3), (-1, 7)])
    series, frame = uid.generate_uid(), uid.generate_uid()
    files = {}
    names = random.sample(range(100), count)
    for n in range(count):
        data = pydicom.Dataset()
        data.SOPClassUID = uid.CTImageStorage
        data.SOPInstanceUID = uid.generate_uid()
        data.Modality = random.choice(["CT", "MR"]) if n == 0 else data_modality
        data_modality = data.Modality
        data.StudyInstanceUID = data.SeriesInstanceUID = series
        data.FrameOfReferenceUID = frame
        data.ImagePositionPatient = [f"{v:.10g}"[:16] for v in numpy.array([1.5, -20.25, 30]) + n * step * axes[2] *
                                     numpy.sign(numpy.dot(numpy.cross(axes[0], axes[1]), axes[2]))]
        data.ImageOrientationPatient = [f"{v:.10f}"[:16] for v in numpy.concatenate([axes[0], axes[1]])]
        data.PixelSpacing = pixel
        data.SliceThickness = step
        data.InstanceNumber = n + 1
        data.Rows, data.Columns, data.SamplesPerPixel = rows, columns, 1
        data.PhotometricInterpretation = "MONOCHROME2"
        data.BitsAllocated = 8 if stored == 8 else 16
        data.BitsStored, data.HighBit, data.PixelRepresentation = stored, stored - 1, signed
        if rescale:
            data.RescaleSlope, data.RescaleIntercept = rescale
        order = ">" if syntax == uid.ExplicitVRBigEndian else "<"
        kind = "u1" if stored == 8 else ("i2" if signed else "u2")
        values = generator.integers(lo, hi, (rows, columns), endpoint=True).astype(kind)
        if stored == 12 and signed and random.random() < 0.5:  # the unused bits may be anything; here: none
            values = values & 0x0FFF
        raw = values.astype(order + kind).tobytes()
        data.PixelData = raw + b"\0" * (len(raw) % 2)
        data["PixelData"].VR = "OB" if stored == 8 else "OW"
        data.file_meta = pydicom.dataset.FileMetaDataset()
        data.file_meta.MediaStorageSOPClassUID = data.SOPClassUID
        data.file_meta.MediaStorageSOPInstanceUID = data.SOPInstanceUID
        data.file_meta.TransferSyntaxUID = uid.ExplicitVRLittleEndian if syntax == uid.RLELossless else syntax
        data.is_little_endian = order == "<"
        data.is_implicit_VR = syntax == uid.ImplicitVRLittleEndian
        if syntax == uid.RLELossless:
            data.compress(uid.RLELossless, encoding_plugin="pydicom")
        out = io.BytesIO()
        pydicom.dcmwrite(out, data, write_like_original=False)
        files[f"{names[n]:03}.dcm"] = out.getvalue()
    return Case("dicom", None if count > 1 or random.random() < 0.5 else next(iter(files)), files)


FORMATS = {"nifti": nifti, "nrrd": nrrd, "meta": meta, "vtk": vtk, "dicom": dicom}
