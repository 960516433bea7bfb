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
struct OpenedLevels;

// Whether a path leads to a store, of which levels can be read box by box, or is the address of one.
bool hasLevels(const std::filesystem::path& path);

class WebStore;

// A store of OME-Zarr, on the disk or on a web server, whose boxes are read by decoders (decision 0030) that
// stay for as long as this object: as many as threads ask at once.
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

    // Where it lies on the disk; of one on a web server, where what was fetched of it does.
    [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
    // Fetches all of a level, where it is on a web server.
    void fetchLevel(int level) const;

private:
    using Decoder = std::unique_ptr<DecoderProcess>;
    [[nodiscard]] Decoder start(OpenedLevels& levels) const;
    [[nodiscard]] Decoder start() const;
    [[nodiscard]] Decoder take() const;
    [[nodiscard]] std::vector<std::byte> received(DecoderProcess& decoder, std::size_t bytes) const;
    void giveBack(Decoder decoder) const;
    template <typename Ask>
    auto answered(const Ask& ask) const;

    [[nodiscard]] std::optional<CellExtremes> extremesFrom(DecoderProcess& decoder) const;
    void fetch(DecoderProcess& decoder, int level, const Box3& box, bool isOfExtremes) const;

    std::filesystem::path path_;
    std::unique_ptr<WebStore> web_; // null: it is on the disk
    std::filesystem::path folder_;
    ReadOptions options_;
    std::vector<GridGeometry> grids_;
    ScalarType type_ = ScalarType::UInt8;
    mutable std::mutex mutex_;
    mutable std::vector<Decoder> idle_;
};

} // namespace vs::volume
