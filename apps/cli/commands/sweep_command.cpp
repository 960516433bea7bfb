// SPDX-License-Identifier: Apache-2.0
#include "commands/commands.h"

#include "arguments/parse.h"
#include "arguments/sweep_arguments.h"
#include "arguments/volume_argument.h"
#include "base/error.h"
#include "gl/context.h"
#include "sculpt/radiation/projection.h"
#include "sculpt/radiation/raw_radiation.h"
#include "sculpt/radiation/sweep.h"
#include "sculpt/sculpture/precision.h"
#include "studio/operations/sweeping.h"
#include "volume/io/write.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <memory>

namespace vs::cli {

namespace {

enum class Energy { Calibrated, Raw };
using Method = studio::Sweep::Method;

// The command line's texts.
struct SweepOptions {
    std::string dims;
    std::string spacing = "1,1,1";
    std::vector<std::string> masks;
    std::vector<std::string> paths;
    std::string frame = "parallel";
    std::string filter = "jittered,bspline,40";
    std::string subdivision;
    double pitch = 0;
    int radius = 3;
    std::string footprint = "gaussian";
    std::string precision = "16";
    std::string energy = "calibrated";
    std::string method = "radiation";
    VolumeArgument clip;
    bool isProbe = false;
    std::string output;
};

// What they ask for.
struct Sweeping {
    volume::GridGeometry geometry;
    sculpt::FootprintShape footprint;
    sculpt::Precision precision = sculpt::Precision::Bits16;
    Energy energy = Energy::Calibrated;
    Method method = Method::Radiation;
    std::vector<sculpt::MaskRaster> masks;
    std::vector<SweepPath> paths; // as many as masks
};

MaskMaking makingOf(const SweepOptions& options, Energy energy) {
    // Raw energy counts elements; a tenth of a step is about a pixel of a picture seen close.
    constexpr double kRawPitch = 0.1;
    MaskMaking making;
    making.pitch =
        options.pitch > 0 ? options.pitch : (energy == Energy::Raw ? kRawPitch : sculpt::kSweepPitch);
    making.filter = parseFilter(options.filter);
    if (!options.subdivision.empty()) {
        parseSubdivision(options.subdivision, making);
    }
    return making;
}

void checkTogether(const SweepOptions& options, const Sweeping& sweeping) {
    if (options.masks.size() != options.paths.size() && options.masks.size() != 1) {
        throw UsageError("{} --mask and {} --path: give one mask a path, or one mask for all",
                         options.masks.size(), options.paths.size());
    }
    if (sweeping.method == Method::Projection && sweeping.energy == Energy::Raw) {
        throw UsageError("--method projection has no energy; leave --energy raw away");
    }
    for (std::size_t n = 0; n < sweeping.paths.size(); ++n) {
        if (sweeping.paths[n].standing && sweeping.energy == Energy::Calibrated) {
            throw UsageError("--path {}: a mask that stands still has no solid; add --energy raw",
                             options.paths[n]);
        }
    }
}

Sweeping understand(const SweepOptions& options, const volume::Volume* clipped) {
    Sweeping sweeping;
    sweeping.geometry = clipped != nullptr
                            ? clipped->geometry
                            : volume::makeGeometry(parseDims(options.dims), parseSpacing(options.spacing));
    sweeping.footprint = parseFootprint(options.footprint, options.radius);
    sweeping.precision = choose<sculpt::Precision>(options.precision, sculpt::kPrecisions, "--precision");
    sweeping.energy = choose<Energy>(options.energy, studio::Sweep::kEnergies, "--energy");
    sweeping.method = choose<Method>(options.method, studio::Sweep::kMethods, "--method");
    const auto kind = choose<sculpt::FrameKind>(options.frame, sculpt::kFrameKinds, "--frame");
    const MaskMaking making = makingOf(options, sweeping.energy);
    sculpt::MaskWindow largest;
    for (const std::string& mask : options.masks) {
        sweeping.masks.push_back(parseMask(mask, making));
        largest.include(sweeping.masks.back().window());
    }
    const glm::dvec3 spacing = sweeping.geometry.spacing();
    const auto grid =
        sculpt::sweepGrid(sweeping.geometry.dims, sculpt::fitFootprint(sweeping.footprint, spacing),
                          sculpt::voxelFromSteps(spacing));
    for (const std::string& path : options.paths) {
        sweeping.paths.push_back(parseSweepPath(path, kind, spacing, grid.region(largest)));
    }
    checkTogether(options, sweeping);
    sweeping.masks.resize(sweeping.paths.size(), sweeping.masks.front());
    return sweeping;
}

// The radiation of each mask along its path, one at a time.
class Radiating {
public:
    explicit Radiating(const Sweeping& sweeping)
        : sweeping_(sweeping), spacing_(sweeping.geometry.spacing()),
          footprint_(sculpt::fitFootprint(sweeping.footprint, spacing_)) {}

    std::vector<float> radiate(const sculpt::MaskRaster& mask, const SweepPath& path) {
        const glm::ivec3 dims = sweeping_.geometry.dims;
        const glm::dvec3 scale = sculpt::voxelFromSteps(spacing_);
        if (sweeping_.energy == Energy::Raw) {
            const auto frames = path.standing ? std::vector<sculpt::MaskFrame>{*path.standing}
                                              : sculpt::framesEachStep(path.pieces);
            sculpt::radiateRaw(radiator_, mask, frames, dims, footprint_, scale);
        } else {
            sculpt::sweepMask(radiator_, generator_, mask, path.pieces, dims, footprint_, scale);
        }
        return radiator_.download(sweeping_.geometry.box());
    }

private:
    const Sweeping& sweeping_;
    glm::dvec3 spacing_;
    sculpt::Footprint footprint_;
    sculpt::Radiator radiator_;
    sculpt::PointGenerator generator_;
};

// Solids are united by their larger value; raw energies add.
void unite(std::vector<float>& all, const std::vector<float>& one, Energy energy) {
    for (std::size_t n = 0; n < all.size(); ++n) {
        all[n] = energy == Energy::Raw ? all[n] + one[n] : std::max(all[n], one[n]);
    }
}

std::vector<float> sweep(const Sweeping& sweeping) {
    std::vector<float> values(sweeping.geometry.voxelCount(), 0.0F);
    if (sweeping.method == Method::Projection) {
        const glm::dvec3 scale = sculpt::voxelFromSteps(sweeping.geometry.spacing());
        for (std::size_t n = 0; n < sweeping.paths.size(); ++n) {
            unite(values,
                  sculpt::projectSweep(sweeping.masks[n], sweeping.paths[n].pieces, sweeping.geometry.dims,
                                       scale),
                  sweeping.energy);
        }
    } else {
        const gl::Context context = gl::Context::createHeadless();
        Radiating radiating(sweeping);
        for (std::size_t n = 0; n < sweeping.paths.size(); ++n) {
            unite(values, radiating.radiate(sweeping.masks[n], sweeping.paths[n]), sweeping.energy);
        }
        context.requireNoErrors();
    }
    if (sweeping.energy == Energy::Calibrated) {
        std::transform(values.begin(), values.end(), values.begin(),
                       [](float e) { return std::clamp(e, 0.0F, 1.0F); });
    }
    sculpt::roundTo(sweeping.precision, values);
    return values;
}

// The volume's own values outside the solid (inside it for a probe); from 0.5 on they go over to its lowest
// value.
std::vector<float> clipped(const volume::Volume& volume, const std::vector<float>& solid, bool isProbe) {
    std::vector<float> values(solid.size());
    volume::visit(volume, [&](const auto* stored) {
        for (std::size_t n = 0; n < solid.size(); ++n) {
            const float removed = std::clamp(isProbe ? 1 - 2 * solid[n] : 2 * solid[n] - 1, 0.0F, 1.0F);
            const auto value = float(stored[n]);
            values[n] = removed > 0 ? value + removed * (float(volume.range.lo) - value) : value;
        }
    });
    return values;
}

void runSweep(const SweepOptions& options) {
    checkGridName(options.output);
    const bool isClip = !options.clip.path.empty();
    if (isClip == !options.dims.empty()) {
        throw UsageError("sweep: give either --dims, for a volume made from nothing, or --clip VOLUME");
    }
    if (options.isProbe && !isClip) {
        throw UsageError("--probe: needs --clip VOLUME to take the probe of");
    }
    const auto input = isClip ? std::optional(loadVolume(options.clip)) : std::nullopt;
    const volume::Volume* volume = input ? &input->volume : nullptr;
    const Sweeping sweeping = understand(options, volume);
    auto values = sweep(sweeping);
    const auto inside = std::count_if(values.begin(), values.end(), [](float e) { return e >= 0.5F; });
    if (volume != nullptr) {
        values = clipped(*volume, values, options.isProbe);
    }
    volume::writeGrid(options.output, sweeping.geometry, std::span<const float>(values));
    fmt::print("{}: {} voxels inside (0.5 and above)\n", options.output, inside);
}

void addShapeOptions(CLI::App& command, SweepOptions& options) {
    command
        .add_option(
            "--mask", options.masks,
            std::string(kMaskForms) +
                ". Sizes in steps (the smallest spacing: voxels on isotropic grids). A picture counts by "
                "its alpha or brightness, half and more inside. May be repeated, one for each --path")
        ->required()
        ->take_all()
        ->expected(1);
    command
        .add_option(
            "--path", options.paths,
            std::string(kPathForms) +
                ". Places in voxels, a helix' ends are those of its axis, its radius in steps. A recorded "
                "FILE has lines X Y Z. at: the mask stands at a place and faces a direction (with "
                "--energy raw). The mask's x is the volume's x made perpendicular to the path (its y "
                "where the path runs along x), its y completes a right-handed frame with the path's "
                "direction. Repeated, the solids are united")
        ->required()
        ->take_all()
        ->expected(1);
    command
        .add_option(
            "--frame", options.frame,
            "How the mask turns along the path: parallel (as little as it can) or frenet (its x follows "
            "the path's principal normal)")
        ->capture_default_str();
    command
        .add_option("--filter", options.filter,
                    "SAMPLING[,RECONSTRUCTION[,WIDTH]] of the mask's edge. Sampling: none, polygon, uniform, "
                    "jittered. Reconstruction: box, tent, gaussian, catmull-rom, mitchell, bspline. Width in "
                    "sub-samples, ten to an element")
        ->capture_default_str();
    command.add_option("--subdivide", options.subdivision,
                       "bspline:LEVELS or chaikin:LEVELS, rounds the outline first");
    command
        .add_option(
            "--pitch", options.pitch,
            "Steps between the mask's elements (0.5; 0.1 with --energy raw, which grows with their number)")
        ->check(between(0.02, 16));
}

void addRadiationOptions(CLI::App& command, SweepOptions& options) {
    command.add_option("--radius", options.radius, "Radius of the radiation in steps: 2, 3 or 4")
        ->capture_default_str();
    command
        .add_option(
            "--footprint", options.footprint,
            "What a point radiates: gaussian, cube or ellipsoid:SX,SY,SZ (standard deviations in steps)")
        ->capture_default_str();
    command
        .add_option("--energy", options.energy,
                    "calibrated (the solid's inside is 1, its 0.5 level on the outline) or raw (each element "
                    "0.1 of its value at each step of the path; several paths add)")
        ->capture_default_str();
    command
        .add_option("--precision", options.precision,
                    "Bits that the result is rounded to: 8 (fixed), 16 or 32 (floating point)")
        ->capture_default_str();
    command
        .add_option("--method", options.method,
                    "radiation, or projection of voxels onto the mask (Winter and Chen), for comparison")
        ->capture_default_str();
}

} // namespace

void addSweepCommand(CLI::App& app) {
    auto* command = app.add_subcommand(
        "sweep", "Sweep masks along paths into a volume made from nothing, or cut one with them");
    const auto options = std::make_shared<SweepOptions>();
    command->add_option("--dims", options->dims, "Voxels of a volume made from nothing: NX,NY,NZ");
    auto* spacing = command->add_option("--spacing", options->spacing, "Its spacing in mm: SX,SY,SZ")
                        ->capture_default_str();
    addShapeOptions(*command, *options);
    addRadiationOptions(*command, *options);
    command
        ->add_option(
            "--clip", options->clip.path,
            "Volume to cut the solid out of, in place of --dims and --spacing: its values, going over to "
            "the lowest of them inside the solid, are written")
        ->excludes(spacing);
    command->add_option("--raw", options->clip.rawLayout,
                        "Layout of a headerless --clip volume, DIMS:TYPE[:SPACING[:OFFSET]], for example "
                        "256x256x108:int16:0.957,0.957,1.5");
    command->add_flag("--probe", options->isProbe, "With --clip: keep what is inside the solid instead");
    command->add_option("-o,--output", options->output, "File to write: .nrrd, .nii, .nii.gz, .mha or .mhd")
        ->required();
    command->callback([options] { runSweep(*options); });
}

} // namespace vs::cli
