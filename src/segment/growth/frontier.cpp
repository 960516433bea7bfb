// SPDX-License-Identifier: Apache-2.0
#include "segment/growth/frontier.h"

#include "gl/context.h"
#include "segment/growth/device_frontier.h"
#include "segment/growth/host_frontier.h"

namespace vs::segment {

GrowthEngine quickerEngine() { return gl::Context::isSoftware() ? GrowthEngine::Host : GrowthEngine::Device; }

std::unique_ptr<Frontier> makeFrontier(GrowthEngine engine, const SeedMap& seedMap,
                                       const field::Field& field) {
    if (engine == GrowthEngine::Host) {
        return std::make_unique<HostFrontier>(seedMap, field);
    }
    return std::make_unique<DeviceFrontier>(seedMap);
}

} // namespace vs::segment
