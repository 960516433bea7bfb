// SPDX-License-Identifier: Apache-2.0
// What is wrong with operations whose members are right one by one.
#include "studio/operations/sweeping.h"

namespace vs::studio {

Fault SweepPath::faultOf() const {
    if (kind == Kind::Standing && points[0] == points[1]) {
        return {"points", "the mask must face another place than it stands on"};
    }
    return {};
}

Fault Clip::faultOf() const {
    if (box && glm::any(glm::greaterThan(box->lo, box->hi))) {
        return {"box", "its first corner must not lie above its second along any axis"};
    }
    return {};
}

Fault Clip::Plane::faultOf() const {
    if (glm::length(normal) < 1e-9) {
        return {"", "its normal must have a length"};
    }
    return {};
}

} // namespace vs::studio
