// SPDX-License-Identifier: Apache-2.0
#include "arguments/storage_argument.h"

#include "reports/progress.h"

#include "base/description.h"
#include "base/error.h"
#include "base/log.h"

namespace vs::cli {

studio::Storage StorageArgument::kind() const {
    return enumeratorOf<studio::Storage>(storage).value_or(studio::Storage::Auto);
}

studio::MemoryBudgets StorageArgument::budgets() const {
    return {deviceMemory.empty() ? 0 : studio::memoryOf(deviceMemory, "--device-memory"),
            hostMemory.empty() ? 0 : studio::memoryOf(hostMemory, "--memory")};
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

namespace {

void print(const std::vector<std::string>& notices, std::size_t from) {
    for (std::size_t n = from; n < notices.size(); ++n) {
        logNotice(notices[n]);
    }
}

} // namespace

studio::OpenedScan loadScan(const VolumeArgument& argument, const StorageArgument& storage) {
    const auto budgets = storage.budgets();
    auto scan = [&] {
        const Activity activity("reading " + argument.path);
        return studio::openScan(argument.path, readOptions(argument), storage.kind(), budgets);
    }();
    print(scan.read.notices, 0);
    return scan;
}

std::unique_ptr<studio::Document> documentOf(studio::OpenedScan scan) {
    auto document = std::make_unique<studio::Document>(std::move(scan.read.volume));
    std::vector<std::string> none;
    showFiner(*document, scan.finer, none);
    return document;
}

std::optional<studio::FinerLevels> findFiner(const volume::Volume& scan, const volume::ReadOptions& read,
                                             const StorageArgument& storage,
                                             std::vector<std::string>& notices) {
    const std::size_t known = notices.size();
    auto levels = studio::finerLevels(scan, read, storage.kind(), storage.budgets(), notices);
    print(notices, known);
    return levels;
}

void showFiner(studio::Document& document, const std::optional<studio::FinerLevels>& levels,
               std::vector<std::string>& notices) {
    const std::size_t known = notices.size();
    studio::showFinerLevels(document, levels, notices);
    print(notices, known);
}

void tellFailures(const studio::Document& document) {
    if (const field::Detail* detail = document.detail()) {
        for (const std::string& failure : detail->failures()) {
            logNotice(failure);
        }
    }
}

} // namespace vs::cli
