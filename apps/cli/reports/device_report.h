// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gl/context.h"
#include "studio/selfcheck/self_check.h"

#include <span>
#include <string>

namespace vs::cli {

// What a person sends to whoever looks into a fault of a device: nothing of it names a file, a folder, a
// person or a computer.

// The program, the current context's device and those of its limits that matter, in lines.
std::string describeDevice(const gl::DeviceInfo& device);
// What the check of one stage has found, in a line, or two where something is wrong.
std::string describe(const studio::StageResult& result);
// The verdict, in one line.
std::string verdictOf(std::span<const studio::StageResult> results);
// All of it for machines: JSON.
std::string jsonOf(const gl::DeviceInfo& device, std::span<const studio::StageResult> results);

} // namespace vs::cli
