// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/description.h"
#include "field/fill/fill.h"

#include <glm/glm.hpp>

#include <memory>
#include <string>
#include <vector>

namespace vs::studio {

// What a person says about a material. Its number is its place in the list, counted from 1.
struct Material {
    std::string name;
    glm::dvec3 colour{0.8}; // sRGB
    double value = 0;       // its intensity, in the scan's unit
    bool isVisible = true;

    // States of sessions keep it so.
    template <typename = void>
    static constexpr auto fields() {
        return std::tuple{required("name", &Material::name, {.leastCount = 1, .mostCount = 200}),
                          required("colour", &Material::colour, {.least = 0, .most = 1}),
                          required("value", &Material::value, {.least = -1e30, .most = 1e30}),
                          required("visible", &Material::isVisible)};
    }
    bool operator==(const Material&) const = default;
};
using Materials = std::shared_ptr<const std::vector<Material>>; // replaced, never changed; never null

// What has been added to a scan: where, and of what.
struct Filled {
    Filled() = default;
    explicit Filled(glm::ivec3 dims) : fill(std::make_shared<const field::Fill>(dims)) {}

    field::SharedFill fill = std::make_shared<const field::Fill>();
    Materials materials = std::make_shared<const std::vector<Material>>();

    // Whether it is the same content, wherever it lies in memory.
    [[nodiscard]] bool isAlike(const Filled& other) const {
        return *fill == *other.fill && *materials == *other.materials;
    }
};

} // namespace vs::studio
