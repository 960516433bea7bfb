// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <utility>

namespace vs::volume {

// The file of a store that is not finished.
inline constexpr const char* kUnfinishedStore = ".volume-studio-unfinished";

// How far the writing of a store has come, in a file of the store that goes when it is done: who writes the
// same again goes on there, and nobody takes half a store for a whole one.
class StoreProgress {
public:
    // `what` says in one line what is written; one that was begun with another is not gone on with. Throws
    // WriteError then, and where there is something else in that place.
    // The store is this one's alone until it goes.
    StoreProgress(const std::filesystem::path& store, const std::string& what);
    ~StoreProgress();
    StoreProgress(const StoreProgress&) = delete;
    StoreProgress& operator=(const StoreProgress&) = delete;

    [[nodiscard]] bool isDone(int level, int slab) const { return done_.contains({level, slab}); }
    // A slab of chunks has been written: it is on the disk when this returns.
    void note(int level, int slab);
    // All has been written.
    void finish();

private:
    void takeUp(const std::string& what);

    std::filesystem::path store_;
    std::filesystem::path file_;
    std::set<std::pair<int, int>> done_;
    int lock_ = -1; // the file, open and locked
};

// Throws ReadError where a store is not finished.
void requireFinished(const std::filesystem::path& store);

} // namespace vs::volume
