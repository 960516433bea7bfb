// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>

#include <cstdint>
#include <span>

namespace vs {

// Reads a message in CBOR from another process, which may be damaged or mean harm. Throws Error where it is
// none, or nested deeper than any of ours.
nlohmann::json fromCbor(std::span<const std::uint8_t> bytes);

} // namespace vs
