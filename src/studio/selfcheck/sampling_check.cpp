// SPDX-License-Identifier: Apache-2.0
#include "studio/selfcheck/checks.h"
#include "studio/selfcheck/made_volumes.h"
#include "studio/selfcheck/queries.h"

#include "field/scene.h"
#include "gl/context.h"
#include "reference/bspline.h"
#include "reference/trilinear.h"

namespace vs::studio {

namespace {

constexpr int kSampledPlaces = 1500;

struct ExpectedSample {
    double value = 0;
    glm::dvec3 gradient{0};
};

// The gradient of trilinear values as scene.glsl defines it: central differences one voxel wide, not beyond
// the grid's box.
ExpectedSample linearSample(const volume::Volume& volume, glm::dvec3 p) {
    glm::dvec3 difference(0);
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 before = p;
        glm::dvec3 after = p;
        before[axis] = std::max(p[axis] - 1, -0.5);
        after[axis] += 1;
        difference[axis] =
            0.5 * (reference::trilinearAt(volume, after) - reference::trilinearAt(volume, before));
    }
    return {reference::trilinearAt(volume, p),
            glm::transpose(glm::dmat3(volume.geometry.voxelFromWorld())) * difference};
}

ExpectedSample cubicSample(const volume::Volume& volume, glm::dvec3 p) {
    const auto sample = reference::bsplineAt(volume, p);
    return {sample.value, sample.gradient};
}

void checkSamples(Tally& tally, const volume::Volume& volume, const field::Field& field,
                  field::Sampling sampling, bool fromQuads, gl::ProgramVariants& programs) {
    const bool isCubic = sampling == field::Sampling::Tricubic;
    field::SceneBinding binding;
    binding.bind(
        {.data = &field, .displayedRange = field.range, .greyWindow = field.range, .sampling = sampling});
    gl::Program& program = programs.with(gl::switchesOn({{"TRICUBIC", isCubic}, {"QUADS", fromQuads}}));
    const auto places = placesIn(volume.geometry.dims, kSampledPlaces);
    const auto answers = answersOf(program, places);
    // Hardware filters know the place between two texels to 8 bits only, along each axis.
    const double part = 1e-5 + (gl::Context::isSoftware() || fromQuads ? 0 : 3.0 / 256);
    const double allowed = part * volume.range.width();
    const std::string how = std::string(namesOf(sampling)[std::size_t(sampling)]) +
                            (fromQuads ? " of quads, " : " of textures, ") + name(volume.type);
    for (std::size_t i = 0; i < places.size(); ++i) {
        const glm::dvec3 p(places[i]);
        const ExpectedSample expected = isCubic ? cubicSample(volume, p) : linearSample(volume, p);
        tally.about("values, " + how);
        tally.compare(double(answers[i].w), expected.value, allowed);
        tally.about("gradients, " + how);
        // A voxel is 0.67 mm wide at the least; differences of two values have twice the error of one.
        tally.compare(glm::length(glm::dvec3(answers[i]) - expected.gradient), 0, 10 * allowed);
    }
}

} // namespace

void checkSampling(Tally& tally) {
    gl::ProgramVariants programs("studio/shaders/sample_values.comp");
    for (const auto type : volume::kScalarTypes) {
        const bool isByte = volume::sizeOf(type) == 1;
        auto volume = makeNoise({23, 17, 11}, type, 0, isByte ? 127 : 30000);
        turnOblique(volume);
        const auto field = field::uploadVolume(volume);
        for (const auto sampling : {field::Sampling::Trilinear, field::Sampling::Tricubic}) {
            checkSamples(tally, volume, field, sampling, false, programs);
            if (field.quads) {
                checkSamples(tally, volume, field, sampling, true, programs);
            }
        }
        if (!field.quads) {
            tally.note("quads are not used on this device");
        }
    }
}

} // namespace vs::studio
