// SPDX-License-Identifier: Apache-2.0
// What was cut at the scene's resolution, cut at the finest.
#include "base/parallel.h"
#include "field/field.h"
#include "sculpt/sculpture/fine_reader.h"

#include <algorithm>
#include <mutex>

namespace vs::sculpt {

namespace {

// Values at the scene's voxels of a box, and between them.
class SceneValues {
public:
    SceneValues(const Box3& box, std::span<const float> values) : box_(box), values_(values) {}

    [[nodiscard]] float at(glm::ivec3 v) const {
        const glm::ivec3 size = box_.size();
        v = glm::clamp(v, box_.lo, box_.hi - 1) - box_.lo;
        return values_[(std::size_t(v.z) * std::size_t(size.y) + std::size_t(v.y)) * std::size_t(size.x) +
                       std::size_t(v.x)];
    }
    [[nodiscard]] float between(const glm::dvec3& p) const {
        const glm::ivec3 v(glm::floor(p));
        const glm::vec3 f(p - glm::dvec3(v));
        float sum = 0;
        for (int n = 0; n < 8; ++n) {
            const glm::ivec3 d(n & 1, (n >> 1) & 1, n >> 2);
            const glm::vec3 w = glm::mix(1.0F - f, f, glm::vec3(d));
            sum += w.x * w.y * w.z * at(v + d);
        }
        return sum;
    }
    [[nodiscard]] Range range(const Box3& part) const {
        Range range{1e30, -1e30};
        forEachVoxel(part, [&](glm::ivec3 v, std::size_t) {
            range.lo = std::min(range.lo, double(at(v)));
            range.hi = std::max(range.hi, double(at(v)));
        });
        return range;
    }

private:
    Box3 box_;
    std::span<const float> values_;
};

} // namespace

void FineSculpture::raise(const Box3& sceneBox, std::span<const float> before, std::span<const float> after,
                          FineBricks& originals, const Limits& limits) {
    constexpr float kHair = 1e-3F;
    const SceneValues was(sceneBox, before);
    const SceneValues is(sceneBox, after);
    const glm::dvec3 lo = glm::dvec3(sceneBox.lo) * grid_.perSceneVoxel + grid_.origin;
    const glm::dvec3 hi = glm::dvec3(sceneBox.hi - 1) * grid_.perSceneVoxel + grid_.origin;
    // The half voxel around the scene's outermost centres belongs to them.
    const glm::dvec3 half = 0.5 * grid_.perSceneVoxel;
    const glm::ivec3 top = counts() - 1;
    const Box3 bricks{glm::clamp(glm::ivec3(glm::max(lo - half, 0.0)) / kFineBrick, glm::ivec3(0), top),
                      glm::clamp(glm::ivec3(glm::max(hi + half, 0.0)) / kFineBrick, glm::ivec3(0), top) + 1};
    std::vector<glm::ivec3> places;
    forEachVoxel(bricks, [&](glm::ivec3 brick, std::size_t) { places.push_back(brick); });
    std::mutex mutex;
    const auto raiseBrick = [&](int n) {
        const glm::ivec3 brick = places[std::size_t(n)];
        const Box3 box = boxOf(placeOf(brick));
        const Box3 scene = intersect(this->sceneBox(box), sceneBox);
        const auto isRaised = [&](float from, float to) { return to > from + kHair; };
        bool any = false;
        bool all = true;
        forEachVoxel(scene, [&](glm::ivec3 v, std::size_t) {
            const bool isHere = isRaised(was.at(v), is.at(v));
            any = any || isHere;
            all = all && isHere;
        });
        if (!any) {
            return;
        }
        const std::vector<float> most = mostEnergiesAtFinest(limits, box);
        if (all && is.range(scene).lo >= 1 && most.empty()) {
            const std::lock_guard lock(mutex);
            fill(brick, true, originals);
            return;
        }
        std::vector<float> values;
        {
            const std::lock_guard lock(mutex);
            values = valuesOf(texels(box), precision_);
        }
        forEachVoxel(box, [&](glm::ivec3 v, std::size_t i) {
            const glm::dvec3 p = (glm::dvec3(v) - grid_.origin) / grid_.perSceneVoxel;
            const float to = is.between(p);
            const float limited = most.empty() ? to : std::min(to, most[i]);
            values[i] = isRaised(was.between(p), to) ? std::max(values[i], limited) : values[i];
        });
        const auto raised = texelsOf(values, precision_);
        const std::lock_guard lock(mutex);
        put(box, raised, originals);
    };
    inParallel(int(places.size()), raiseBrick);
}

} // namespace vs::sculpt
