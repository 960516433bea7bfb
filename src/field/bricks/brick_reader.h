// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/bricks/brick_cache.h"
#include "field/bricks/brick_ranges.h"
#include "field/bricks/brick_texels.h"
#include "volume/grid/brick_source.h"

#include <condition_variable>
#include <memory>
#include <mutex>
#include <set>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

namespace vs::field {

// A brick that has been read.
struct ReadBrick {
    BrickKey key;
    std::vector<std::byte> texels; // texels()^3 of its grid, x fastest; none where reading it failed
    BrickRanges ranges;            // what samples of these can have
    std::string failure;           // why, in one line
};

// Threads that read bricks beside whoever draws them.
class BrickReader {
public:
    // `grids` are those of the source's levels, the finest first.
    BrickReader(std::shared_ptr<const volume::BrickSource> source, std::vector<BrickGrid> grids,
                std::size_t cacheBytes, int threads);
    ~BrickReader();
    BrickReader(const BrickReader&) = delete;
    BrickReader& operator=(const BrickReader&) = delete;

    // From now on these are wanted, in this order, and no others: what was wanted before and has not been
    // begun is forgotten. When some have been read that nobody takes, no more are read.
    void want(const std::vector<BrickKey>& keys);
    // Waits up to so long until something wanted has been read, if anything is being read, and gives all of
    // that.
    std::vector<ReadBrick> take(double waitMs);
    // How many are wanted and have not been given.
    [[nodiscard]] std::size_t outstanding() const;
    [[nodiscard]] std::size_t cachedBytes() const { return cache_.bytes(); }

private:
    void work(const std::stop_token& stop);
    [[nodiscard]] ReadBrick read(const BrickKey& key);
    [[nodiscard]] std::vector<std::byte> texelsOf(const BrickKey& key);

    std::shared_ptr<const volume::BrickSource> source_;
    std::vector<BrickGrid> grids_;
    BrickCache cache_;
    mutable std::mutex mutex_;
    std::condition_variable_any hasChanged_;
    std::vector<BrickKey> wanted_; // the one to be read next last
    std::set<BrickKey> inHand_;    // those that are being read
    std::vector<ReadBrick> done_;
    std::vector<std::jthread> threads_; // last: they end before all else goes
};

} // namespace vs::field
