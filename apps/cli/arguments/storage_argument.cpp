// SPDX-License-Identifier: Apache-2.0
#include "arguments/storage_argument.h"

#include "reports/progress.h"

#include "base/description.h"
#include "base/error.h"
#include "base/log.h"

#include <cmath>
#include <charconv>

namespace vs::cli {

studio::Storage StorageArgument::kind() const {
    return enumeratorOf<studio::Storage>(storage).value_or(studio::Storage::Auto);
}

studio::MemoryBudgets StorageArgument::budgets() const {
    return {deviceMemory.empty() ? 0 : parseMemory(deviceMemory, "--device-memory"),
            hostMemory.empty() ? 0 : parseMemory(hostMemory, "--memory")};
}

void addStorageOptions(CLI::App& command, StorageArgument& argument) {
    command
        .add_option("--storage", argument.storage,
                    "dense: one level in one texture; bricks: pictures are drawn from bricks, what would fit "
                    "too; auto: where a store has finer levels than the one that is worked on")
        ->check(CLI::IsMember(studio::kStorages))
        ->capture_default_str();
    command.add_option("--device-memory", argument.deviceMemory,
                       "What volumes and edits may take on the device, for example 512MiB or 4GiB; without, "
                       "what this machine has");
    command.add_option("--memory", argument.hostMemory, "What they may take on the host, likewise");
}

std::size_t parseMemory(const std::string& text, const std::string& what) {
    double number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    const std::string unit(end, text.data() + text.size());
    const double mebibytes = unit.empty() || unit == "MiB" ? number : unit == "GiB" ? 1024 * number : -1;
    if (error != std::errc() || !(mebibytes >= 1) || mebibytes > 1e9) {
        throw UsageError("{} {}: it is no amount of memory; give one as 512MiB or 4GiB", what, text);
    }
    return std::size_t(mebibytes * 1024 * 1024);
}

studio::OpenedScan loadScan(const VolumeArgument& argument, const StorageArgument& storage) {
    const auto budgets = storage.budgets();
    auto scan = [&] {
        const Activity activity("reading " + argument.path);
        return studio::openScan(argument.path, readOptions(argument), storage.kind(), budgets);
    }();
    for (const auto& notice : scan.read.notices) {
        logNotice(notice);
    }
    return scan;
}

std::unique_ptr<studio::Document> documentOf(studio::OpenedScan scan) {
    auto document = std::make_unique<studio::Document>(std::move(scan.read.volume));
    if (scan.finer) {
        document->showFinerLevels(*scan.finer);
    }
    return document;
}

} // namespace vs::cli
