// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "volume/grid/brick_source.h"
#include "volume/io/read.h"

#include <filesystem>
#include <memory>
#include <mutex>
#include <vector>

namespace vs::volume {

class DecoderProcess;

// Whether a path leads to a store, of which levels can be read box by box.
bool hasLevels(const std::filesystem::path& path);

// A store of OME-Zarr whose boxes are read by decoders (decision 0030) that stay for as long as this object:
// as many as threads ask at once.
class StoreBricks : public BrickSource {
public:
    // `channel` and `frame` of the options are chosen; `level` counts for nothing. Throws ReadError.
    StoreBricks(std::filesystem::path path, const ReadOptions& options);
    ~StoreBricks() override;

    [[nodiscard]] const std::vector<GridGeometry>& levels() const override { return grids_; }
    [[nodiscard]] ScalarType type() const override { return type_; }
    [[nodiscard]] std::string name() const override { return path_.string(); }
    [[nodiscard]] std::vector<std::byte> read(int level, const Box3& box) const override;
    [[nodiscard]] std::optional<CellExtremes> extremes() const override;

private:
    struct Levels;
    using Decoder = std::unique_ptr<DecoderProcess>;
    [[nodiscard]] Decoder start(Levels& levels) const;
    [[nodiscard]] Decoder start() const;
    [[nodiscard]] Decoder take() const;
    [[nodiscard]] std::vector<std::byte> received(DecoderProcess& decoder, std::size_t bytes) const;
    void giveBack(Decoder decoder) const;

    std::filesystem::path path_;
    ReadOptions options_;
    std::vector<GridGeometry> grids_;
    ScalarType type_ = ScalarType::UInt8;
    mutable std::mutex mutex_;
    mutable std::vector<Decoder> idle_;
};

} // namespace vs::volume
