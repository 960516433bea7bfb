// SPDX-License-Identifier: Apache-2.0
// What a picture consists of: pasted parts, segments that are pulled out, and what remains, each seen along
// rays of its own.
#include "base/check.h"
#include "render/rays/ray_caster.h"
#include "render/shaders/bindings.h"

namespace vs::render {

// Side of the square of pixels whose rays share a beam, as a power of 2; narrower ones bound values better,
// but each takes memory.
int RayCaster::beamShift(const Frame& frame) {
    constexpr std::int64_t manyPixels = std::int64_t(1) << 22;
    return frame.mode == Mode::Mip && std::int64_t(frame.rays.size.x) * frame.rays.size.y <= manyPixels ? 2
                                                                                                        : 3;
}

int RayCaster::beamPixels(const Frame& frame) { return 1 << beamShift(frame); }

void RayCaster::arrangeParts() {
    parts_.resize(frame_.pasted.size() + frame_.pulled.size() + 1);
    const auto& geometry = frame_.scene.data->geometry;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
        Part& part = parts_[i];
        part.scene = frame_.scene;
        part.defines = definesFor(frame_);
        part.pulled.reset();
        part.macrocells = frame_.macrocells;
        part.segmentCells = frame_.segmentCells;
        part.occlusion = frame_.occlusion;
        part.rays = frame_.rays;
        part.scale = 1;
        if (i < frame_.pasted.size()) {
            become(part, frame_.pasted[i]);
        } else if (i + 1 < parts_.size()) {
            become(part, frame_.pulled[i - frame_.pasted.size()]);
        }
        part.view.reserve(sizeof(ViewBlock));
        part.view.writeValue(viewBlock(part.rays, geometry));
        const int side = beamPixels(frame_);
        const glm::ivec2 beams = (frame_.rays.size + side - 1) / side;
        if (glm::ivec2(part.beams.size()) != beams) {
            part.beams = gl::Texture(beams, gl::Format::RG32F, gl::Filter::Nearest, "beams");
        }
    }
}

void RayCaster::become(Part& part, const PastedPart& pasted) {
    VS_CHECK(pasted.macrocells != nullptr);
    // What is finer is that of all that was cut, and of segments as they end there.
    Frame coarse = frame_;
    coarse.scene.hasFinerCuts = part.scene.hasFinerCuts && pasted.sculpture == frame_.scene.sculpture;
    coarse.scene.hasFinerSegments = part.scene.hasFinerSegments && pasted.segmentation == nullptr;
    coarse.scene.fill = nullptr; // parts are of the scan alone
    if (coarse.scene.hasFinerCuts != part.scene.hasFinerCuts ||
        coarse.scene.hasFinerSegments != part.scene.hasFinerSegments || part.scene.fill != nullptr) {
        part.scene.hasFinerCuts = coarse.scene.hasFinerCuts;
        part.scene.hasFinerSegments = coarse.scene.hasFinerSegments;
        part.defines = definesFor(coarse);
    }
    part.scene.sculpture = pasted.sculpture;
    part.scene.view = field::SculptureView::Probe;
    part.scene.fill = nullptr;
    if (pasted.segmentation != nullptr) {
        part.scene.segmentation = pasted.segmentation;
    }
    part.macrocells = pasted.macrocells;
    part.occlusion = pasted.occlusion;
    place(part, pasted.place);
}

void RayCaster::become(Part& part, const PulledSegment& segment) {
    VS_CHECK(segment.macrocells != nullptr && segment.scene.segmentation != nullptr);
    part.scene = segment.scene;
    part.scene.fill = nullptr;
    part.defines = definesFor(frame_, segment);
    part.pulled = glm::ivec2(segment.label, segment.isTranslucent ? 1 : 0);
    part.macrocells = part.segmentCells = segment.macrocells;
    part.occlusion = nullptr;
    place(part, segment.place);
}

void RayCaster::place(Part& part, const Placement& placement) {
    part.rays = seenFromPart(frame_.rays, placement, frame_.scene.data->geometry);
    part.scale = float(placement.scale);
}

void RayCaster::bindPart(const Part& part) {
    sceneBinding_.bind(part.scene);
    part.view.bindUniform(kViewBlock);
    part.macrocells->bind();
    if (frame_.detail != nullptr) {
        frame_.detail->use(*level_);
        Frame seen = frame_;
        seen.scene = part.scene;
        if (part.pulled && part.scene.apartPages != nullptr) { // has its own texture where those would be
            seen.scene.hasFinerCuts = seen.scene.hasFinerSegments = false;
        }
        frame_.detail->bind(layersOf(seen));
    }
    part.beams.bindTexture(kBeamsTexture);
    if (frame_.mode == Mode::Mip) {
        part.slabs.bind();
    }
    const bool looksForSegments = frame_.mode == Mode::Overlay || frame_.mode == Mode::Volume ||
                                  (frame_.mode == Mode::Segment && frame_.detail != nullptr);
    if (looksForSegments) {
        const Macrocells* cells = part.segmentCells != nullptr ? part.segmentCells : part.macrocells;
        cells->distances().bindTexture(kSegmentCellDistancesTexture);
    }
    if (part.occlusion != nullptr) {
        part.occlusion->bind({.towardsKey = towardsKeyLight(part.rays)});
    }
}

} // namespace vs::render
