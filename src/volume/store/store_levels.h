// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "volume/grid/brick_source.h"
#include "volume/io/read.h"
#include "volume/store/multiscales.h"

#include <string>
#include <vector>

namespace vs::volume {

// All levels of a store, read box by box in this process, with the libraries that decode it: for the decoder
// and for tests (all others: volume/reading/store_bricks.h). `channel` and `frame` of the options are chosen
// as readStore() does.
class StoreLevels : public BrickSource {
public:
    // Throws ReadError.
    StoreLevels(const std::filesystem::path& path, const ReadOptions& options);

    [[nodiscard]] const std::vector<GridGeometry>& levels() const override { return grids_; }
    [[nodiscard]] ScalarType type() const override { return type_; }
    [[nodiscard]] std::string name() const override { return store_.path.filename().string(); }
    [[nodiscard]] std::vector<std::byte> read(int level, const Box3& box) const override;
    [[nodiscard]] std::optional<CellExtremes> extremes() const override;
    // What can be said without them, of a store all of which is there (missing_chunks.h).
    [[nodiscard]] std::optional<CellExtremes> extremesByMissing() const;

    // The files that a box's values are in, and the extremes: names in the store.
    [[nodiscard]] std::vector<std::string> filesOf(int level, const Box3& box) const;
    [[nodiscard]] std::vector<std::string> filesOfExtremes() const;

private:
    void expectInside(int level, const Box3& box) const;

    Multiscales store_;
    std::vector<GridGeometry> grids_;
    ScalarType type_ = ScalarType::Float32;
    int channel_ = 0;
    int time_ = 0;
};

} // namespace vs::volume
