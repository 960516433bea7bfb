#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Times VTK's CPU and GPU volume mappers on one volume, with the cameras and settings of bench/scene.json.

Needs an X display (bench/compare brings one), Debian's python3-vtk9, and what `vstudio info --json` says of the
volume. Prints JSON: for each mapper and mode the milliseconds of every frame, after one frame that warms up.
"""
import argparse
import json
import pathlib
import statistics
import sys
import time

import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk

import camera
import volume_file

SCENE = pathlib.Path(__file__).resolve().parent.parent / "scene.json"
MODES = ("surface", "mip", "volume")


def make_image(path, info):
    """The voxels at the origin, axis-aligned, and the matrix that places them in the world (LPS, mm)."""
    values = volume_file.read(path)
    if list(values.shape[::-1]) != info["dims"]:
        sys.exit(f"{path}: {values.shape[::-1]} voxels, but vstudio says {info['dims']}")
    world = np.array(info["worldFromVoxel"])
    if np.linalg.det(world[:3, :3]) < 0:  # VTK's mappers want no mirroring: turn the first axis around
        values = np.ascontiguousarray(values[:, :, ::-1])
        world[:3, 3] += world[:3, 0] * (info["dims"][0] - 1)
        world[:3, 0] *= -1
    spacing = np.linalg.norm(world[:3, :3], axis=0)
    image = vtk.vtkImageData()
    image.SetDimensions(info["dims"])
    image.SetSpacing(spacing)
    image.GetPointData().SetScalars(numpy_to_vtk(values.reshape(-1)))
    image.values = values  # VTK does not keep the array alive
    world[:3, :3] /= spacing
    return image, world


def place(world):
    matrix = vtk.vtkMatrix4x4()
    matrix.DeepCopy(world.reshape(-1))
    return matrix


def opacity_of(mode, lo, hi, full, scene):
    """Opacity per smallest spacing, over values."""
    width = hi - lo
    edge = 1e-4 * width
    function = vtk.vtkPiecewiseFunction()
    if mode == "mip":
        points = [(full[0], 0), (full[1], 1)]
    elif mode == "surface":
        points = [(lo - edge, 0), (lo, 1), (hi, 1), (hi + edge, 0)]
    else:
        points = [(lo + width * at, opacity) for at, opacity in scene["transferFunction"]["opacity"]]
        points = [(lo - edge, 0), *points, (hi + edge, 0)]
    for value, opacity in points:
        function.AddPoint(value, opacity)
    return function


def colour_of(mode, lo, hi, scene):
    function = vtk.vtkColorTransferFunction()
    if mode == "mip":
        function.AddRGBPoint(lo, 1, 1, 1)  # the opacity makes the greys
    elif mode == "surface":
        function.AddRGBPoint(lo, 0.86, 0.80, 0.70)
    else:
        for at, colour in scene["transferFunction"]["colour"]:
            function.AddRGBPoint(lo + (hi - lo) * at, *colour)
    return function


def make_property(mode, info, lo, hi, scene):
    prop = vtk.vtkVolumeProperty()
    prop.SetInterpolationTypeToLinear()
    prop.SetScalarOpacity(opacity_of(mode, lo, hi, info["range"], scene))
    prop.SetColor(colour_of(mode, lo, hi, scene))
    prop.SetScalarOpacityUnitDistance(min(info["spacing"]))
    prop.SetShade(mode != "mip")
    prop.SetAmbient(0.2)
    prop.SetDiffuse(0.8)
    prop.SetSpecular(0.2)
    prop.SetSpecularPower(40)
    return prop


def make_mapper(which, mode, image, info, lo, prop, scene):
    mapper = vtk.vtkFixedPointVolumeRayCastMapper() if which == "cpu" else vtk.vtkOpenGLGPUVolumeRayCastMapper()
    mapper.SetInputData(image)
    # Every pixel of every frame is cast, at the same step.
    mapper.AutoAdjustSampleDistancesOff()
    mapper.LockSampleDistanceToInputSpacingOff()
    mapper.SetSampleDistance(scene["sampleDistance"] * min(info["spacing"]))
    mapper.SetImageSampleDistance(1)
    if which == "cpu":
        mapper.IntermixIntersectingGeometryOff()
    if mode == "mip":
        mapper.SetBlendModeToMaximumIntensity()
    elif mode == "surface" and which == "gpu":
        mapper.SetBlendModeToIsoSurface()
        prop.GetIsoSurfaceValues().SetValue(0, lo)
    else:
        mapper.SetBlendModeToComposite()
    return mapper


def make_window(size):
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetSize(*size)
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(0.1, 0.11, 0.13)
    window.AddRenderer(renderer)
    return window, renderer


def write_picture(window, path):
    grab = vtk.vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    writer = vtk.vtkPNGWriter()
    writer.SetFileName(str(path))
    writer.SetInputConnection(grab.GetOutputPort())
    writer.Write()


def device_of(window):
    wanted = ("OpenGL renderer string", "OpenGL version string")
    lines = [line.split(":", 1) for line in window.ReportCapabilities().splitlines() if ":" in line]
    return ", ".join(value.strip() for key, value in lines if key.strip() in wanted)


class Bench:
    def __init__(self, options, info, scene):
        self.options, self.info, self.scene = options, info, scene
        self.image, self.world = make_image(options.volume, info)
        self.lo, self.hi = options.range

    def frame(self, window, renderer, azimuth):
        camera.aim(renderer, camera.pose(self.info, azimuth, self.scene["elevation"], self.scene["size"]))
        start = time.perf_counter()
        window.Render()
        window.WaitForCompletion()
        return 1000 * (time.perf_counter() - start)

    def measure(self, which, mode, frames):
        window, renderer = make_window(self.scene["size"])
        prop = make_property(mode, self.info, self.lo, self.hi, self.scene)
        mapper = make_mapper(which, mode, self.image, self.info, self.lo, prop, self.scene)
        volume = vtk.vtkVolume()
        volume.SetMapper(mapper)
        volume.SetProperty(prop)
        volume.SetUserMatrix(place(self.world))
        renderer.AddVolume(volume)
        azimuths = self.scene["azimuths"]
        first = self.frame(window, renderer, azimuths[-1])
        times, drawing = [], []
        for i in range(frames):
            times.append(self.frame(window, renderer, azimuths[i % len(azimuths)]))
            drawing.append(1000 * mapper.GetTimeToDraw())
        if self.options.pictures:
            self.frame(window, renderer, azimuths[0])
            self.options.pictures.mkdir(parents=True, exist_ok=True)
            write_picture(window, self.options.pictures / f"vtk_{which}_{mode}.png")
        result = {"mapper": mapper.GetClassName(), "device": device_of(window), "firstMilliseconds": first,
                  "milliseconds": times, "medianMilliseconds": statistics.median(times)}
        if which == "cpu":
            result["threads"] = mapper.GetNumberOfThreads()
            result["castingMilliseconds"] = statistics.median(drawing)
        window.Finalize()
        return result


def parse(argv):
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("volume")
    parser.add_argument("--info", required=True, type=pathlib.Path, help="file with what `vstudio info --json` says")
    parser.add_argument("--range", required=True, type=lambda text: [float(n) for n in text.split(":")],
                        help="displayed range LO:HI of surface and volume; MIP takes all values")
    parser.add_argument("--mappers", default="cpu,gpu", help="cpu, gpu or both")
    parser.add_argument("--modes", default=",".join(MODES))
    parser.add_argument("--frames", type=int, default=8, help="frames after the first (default 8)")
    parser.add_argument("--scene", type=pathlib.Path, default=SCENE)
    parser.add_argument("--pictures", type=pathlib.Path, help="folder for a PNG of the first camera")
    return parser.parse_args(argv)


def main():
    options = parse(sys.argv[1:])
    scene = json.loads(options.scene.read_text(encoding="utf-8"))
    bench = Bench(options, json.loads(options.info.read_text(encoding="utf-8")), scene)
    results = {which: {mode: bench.measure(which, mode, options.frames) for mode in options.modes.split(",")}
               for which in options.mappers.split(",")}
    json.dump({"program": f"VTK {vtk.vtkVersion.GetVTKVersion()}", "volume": options.volume, "range": options.range,
               "size": scene["size"], "results": results}, sys.stdout, indent=1)
    print()


if __name__ == "__main__":
    main()
