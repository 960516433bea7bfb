// SPDX-License-Identifier: Apache-2.0
#include "reports/device_report.h"

#include "gl/limits.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace vs::cli {

namespace {

using Json = nlohmann::ordered_json;

std::size_t wrongStages(std::span<const studio::StageResult> results) {
    return std::size_t(
        std::count_if(results.begin(), results.end(), [](const auto& result) { return !result.isOk(); }));
}

// An error that may be infinite, which JSON has no number for.
Json numberOf(double value) { return std::isfinite(value) ? Json(value) : Json("not a number"); }

// What is wrong with a stage.
std::string faultsOf(const studio::StageResult& result) {
    const auto& tally = result.tally;
    std::string text;
    const auto add = [&text](const std::string& fault) { text += (text.empty() ? "" : "; ") + fault; };
    if (!result.failure.empty()) {
        add("ended early: " + result.failure);
    }
    if (tally.wrong() > 0) {
        const auto& worst = tally.worst();
        add(fmt::format("{} of {} values differ; the worst of {}: off by {:.3g}, {:.3g} is allowed",
                        tally.wrong(), tally.values(), worst.what, worst.error, worst.allowed));
    }
    if (result.errors > 0) {
        add(fmt::format("{} OpenGL errors", result.errors));
    }
    return text.empty() ? "nothing could be compared" : text;
}

} // namespace

std::string describeDevice(const gl::DeviceInfo& device) {
    const auto limits = gl::limits();
    const auto compute = gl::computeLimits();
    std::string text = "Volume Studio " VOLUME_STUDIO_VERSION ", check of a device\n";
    text += fmt::format("vendor:    {}\nrenderer:  {}{}\nversion:   OpenGL {}\n", device.vendor,
                        device.renderer, device.isSoftware ? " (software)" : "", device.version);
    text += fmt::format("textures:  {} texels along an axis in 3D, {} in 2D, {} in a row of texels\n",
                        limits.texture3D, limits.texture2D, limits.texelBufferTexels);
    text += fmt::format("memory:    {} MiB in a storage block, {} bytes shared by a group\n",
                        limits.storageBlockBytes >> 20, compute.sharedBytes);
    text += fmt::format("groups:    {} x {} x {} of a dispatch; {} x {} x {}, in all {} invocations in one\n",
                        compute.groups.x, compute.groups.y, compute.groups.z, compute.groupSize.x,
                        compute.groupSize.y, compute.groupSize.z, compute.groupInvocations);
    text += fmt::format("bindings:  {} storage blocks, {} images, {} textures\n", compute.storageBlocks,
                        compute.images, compute.textures);
    return text;
}

std::string describe(const studio::StageResult& result) {
    const auto& tally = result.tally;
    const std::string head = fmt::format("{:<28} {:<6} {:>6.0f} ms", result.name,
                                         result.isOk() ? "ok" : "WRONG", result.milliseconds);
    if (!result.isOk()) {
        return fmt::format("{}\n   {}\n", head, faultsOf(result));
    }
    const auto& worst = tally.worst();
    std::string text = fmt::format("{}  {} values", head, tally.values());
    if (worst.error > 0) {
        text += fmt::format("; at most off by {:.2g} of {:.2g} allowed ({})", worst.error, worst.allowed,
                            worst.what);
    }
    return text + (tally.noted().empty() ? "" : "; " + tally.noted()) + "\n";
}

std::string verdictOf(std::span<const studio::StageResult> results) {
    double milliseconds = 0;
    std::string wrong;
    for (const auto& result : results) {
        milliseconds += result.milliseconds;
        wrong += result.isOk() ? "" : (wrong.empty() ? "" : ", ") + result.name;
    }
    if (wrong.empty()) {
        return fmt::format("all {} stages are right on this device ({:.1f} s)\n", results.size(),
                           milliseconds / 1000);
    }
    return fmt::format("{} of {} stages are wrong on this device: {} ({:.1f} s)\n", wrongStages(results),
                       results.size(), wrong, milliseconds / 1000);
}

std::string jsonOf(const gl::DeviceInfo& device, std::span<const studio::StageResult> results) {
    const auto limits = gl::limits();
    const auto compute = gl::computeLimits();
    const auto axes = [](glm::ivec3 v) { return Json{v.x, v.y, v.z}; };
    Json stages = Json::array();
    for (const auto& result : results) {
        const auto& worst = result.tally.worst();
        Json stage{
            {"name", result.name},
            {"ok", result.isOk()},
            {"values", result.tally.values()},
            {"wrong", result.tally.wrong()},
            {"worst",
             {{"of", worst.what}, {"error", numberOf(worst.error)}, {"allowed", numberOf(worst.allowed)}}},
            {"glErrors", result.errors},
            {"ms", result.milliseconds}};
        if (!result.failure.empty()) {
            stage["failure"] = result.failure;
        }
        if (!result.tally.noted().empty()) {
            stage["note"] = result.tally.noted();
        }
        stages.push_back(std::move(stage));
    }
    const Json report{{"program", "vstudio " VOLUME_STUDIO_VERSION},
                      {"device",
                       {{"vendor", device.vendor},
                        {"renderer", device.renderer},
                        {"version", device.version},
                        {"isSoftware", device.isSoftware}}},
                      {"limits",
                       {{"texture3D", limits.texture3D},
                        {"texture2D", limits.texture2D},
                        {"texelBufferTexels", limits.texelBufferTexels},
                        {"storageBlockBytes", limits.storageBlockBytes},
                        {"sharedBytes", compute.sharedBytes},
                        {"groups", axes(compute.groups)},
                        {"groupSize", axes(compute.groupSize)},
                        {"groupInvocations", compute.groupInvocations},
                        {"storageBlocks", compute.storageBlocks},
                        {"images", compute.images},
                        {"textures", compute.textures}}},
                      {"stages", stages},
                      {"ok", wrongStages(results) == 0}};
    return report.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace vs::cli
