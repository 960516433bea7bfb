// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/field.h"

namespace vs::segment {

// A field's values on the host: those of its volume where the field knows it, else read back from the device
// once. Internal to this folder.
class HostValues {
public:
    // `field` must outlive this.
    explicit HostValues(const field::Field& field) : field_(&field) {}

    // The values, in volume::Volume::bytes. Throws std::bad_alloc. Needs a current context.
    const volume::Volume& get();

private:
    const field::Field* field_;
    volume::Volume read_;
    bool isRead_ = false;
};

} // namespace vs::segment
