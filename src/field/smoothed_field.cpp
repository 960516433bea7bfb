// SPDX-License-Identifier: Apache-2.0
#include "field/smoothed_field.h"

#include "base/check.h"
#include "base/progress.h"
#include "field/shaders/bindings.h"
#include "gl/pass.h"

#include <array>
#include <cmath>

namespace vs::field {

namespace {

constexpr int kMostReach = 6; // voxels, as in smooth_values.comp
constexpr int kSlab = 32;     // slices smoothed at a time
static_assert(kMostReach >= 3 * kMostSigmaSteps);

// The Gaussian's integrals over voxels at distance 0, 1, ... along one axis, normalised to sum 1 over both
// sides. Not its values there: a narrow one would be far off.
struct Kernel {
    std::array<float, kMostReach + 1> weights{};
    int reach = 0;
};

Kernel kernelOf(double sigmaVoxels) {
    Kernel kernel;
    kernel.reach = std::clamp(int(std::ceil(3 * sigmaVoxels)), 1, kMostReach);
    const auto below = [&](double x) { return 0.5 * std::erf(x / (sigmaVoxels * std::sqrt(2.0))); };
    double sum = 0;
    for (int i = 0; i <= kernel.reach; ++i) {
        const double weight = below(i + 0.5) - below(i - 0.5);
        kernel.weights[std::size_t(i)] = float(weight);
        sum += i == 0 ? weight : 2 * weight;
    }
    for (float& weight : kernel.weights) {
        weight = float(weight / sum);
    }
    return kernel;
}

// Smoothing along one axis at a time.
class AxisPass {
public:
    AxisPass(const Field& source, double sigmaSteps)
        : dims_(source.geometry.dims), isMasked_(!source.isIntegral) {
        const glm::dvec3 spacing = source.geometry.spacing();
        for (int axis = 0; axis < 3; ++axis) {
            kernels_[std::size_t(axis)] = kernelOf(sigmaSteps * source.geometry.stepMm() / spacing[axis]);
        }
    }

    [[nodiscard]] int reachAlongZ() const { return kernels_[2].reach; }

    // Smooths the grid's slices [first, end). `source` holds slices from `sourceFirst` on, `target` takes
    // them from its slice `targetFirst` on. Values are scaled and offset on their way: along z when they are
    // written, along the other axes when they are read.
    void run(int axis, const gl::Texture& source, int sourceFirst, const gl::Texture& target, int targetFirst,
             int first, int end, glm::vec2 scaleAndOffset) {
        const Kernel& kernel = kernels_[std::size_t(axis)];
        gl::Defines defines{{"VS_FORMAT", target.format() == gl::Format::R16 ? "r16" : "r32f"},
                            {"VS_REACH", std::to_string(kernel.reach)}};
        if (isMasked_) {
            defines.emplace_back("VS_MASKED", "1");
        }
        gl::Program& program = programs_.with(defines);
        source.bindTexture(kSourceTexture);
        target.bindImage(kTargetImage, gl::Access::Write);
        program.set("dims", dims_)
            .set("axisAtWork", axis)
            .set("task", glm::ivec2(first, end))
            .set("slices", glm::ivec3(sourceFirst, source.size().z, targetFirst))
            .set("map", scaleAndOffset)
            .set("near",
                 glm::vec4(kernel.weights[0], kernel.weights[1], kernel.weights[2], kernel.weights[3]))
            .set("far", glm::vec3(kernel.weights[4], kernel.weights[5], kernel.weights[6]));
        glm::ivec3 runs{dims_.x, dims_.y, end - first};
        runs[axis] = (runs[axis] + kRun - 1) / kRun;
        program.dispatchOver(runs, gl::Barrier::All);
    }

private:
    static constexpr int kRun = 16; // voxels that an invocation smooths in a row, as in smooth_values.comp
    glm::ivec3 dims_;
    bool isMasked_;
    gl::ProgramVariants programs_{"field/shaders/smooth_values.comp"};
    std::array<Kernel, 3> kernels_;
};

// A field of the same geometry for smoothed values, still without any.
Field emptyLike(const Field& source, std::uint64_t serial) {
    Field out;
    out.geometry = source.geometry;
    out.range = source.range;
    out.usual = source.usual;
    out.serial = serial;
    const gl::Format format = source.isIntegral ? gl::Format::R16 : gl::Format::R32F;
    out.texels = gl::Texture(source.geometry.dims, format, gl::Filter::Linear, "smoothed data");
    out.mayHaveQuads = source.mayHaveQuads;
    out.quads = out.mayHaveQuads ? makeQuads(source.geometry.dims, format) : gl::TexelBuffer();
    if (source.isIntegral) {
        out.valueScale = float(std::max(source.range.width(), 1.0));
        out.valueOffset = float(source.range.lo);
    }
    return out;
}

} // namespace

SmoothedField smoothField(const Field& source, double sigmaSteps) {
    VS_CHECK(sigmaSteps > 0 && sigmaSteps <= kMostSigmaSteps);
    const gl::Pass pass("smooth values");
    SmoothedField out;
    out.sigmaSteps = sigmaSteps;
    out.field = emptyLike(source, nextSerial());
    AxisPass along(source, sigmaSteps);
    const glm::ivec3 dims = source.geometry.dims;
    const glm::ivec3 slab{dims.x, dims.y, std::min(dims.z, kSlab + 2 * along.reachAlongZ())};
    const gl::Texture alongX(slab, gl::Format::R32F, gl::Filter::Nearest, "smoothed along x");
    const gl::Texture alongXY(slab, gl::Format::R32F, gl::Filter::Nearest, "smoothed along x and y");
    const glm::vec2 asValues(source.valueScale, source.valueOffset);
    const glm::vec2 asTexels(1 / out.field.valueScale, -out.field.valueOffset / out.field.valueScale);
    for (int z = 0; z < dims.z; z += kSlab) {
        reportProgress(double(z) / dims.z);
        const int end = std::min(z + kSlab, dims.z);
        const int first = std::max(z - along.reachAlongZ(), 0);
        const int past = std::min(end + along.reachAlongZ(), dims.z);
        along.run(0, source.texels, 0, alongX, 0, first, past, asValues);
        along.run(1, alongX, first, alongXY, 0, first, past, {1, 0});
        along.run(2, alongXY, first, out.field.texels, z, z, end, asTexels);
    }
    if (out.field.quads) {
        fillQuads(out.field.texels, out.field.quads);
    }
    out.cells = computeCellRanges(out.field);
    return out;
}

} // namespace vs::field
