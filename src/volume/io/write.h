// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "volume/grid/volume.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>

namespace vs::volume {

// Checks the name of a file to write: throws WriteError if its extension is none that writeGrid knows.
void checkGridName(const std::filesystem::path& path);

// Each writes a grid (x fastest, geometry.voxelCount() values) with its place in the patient, as NIfTI, NRRD
// or MetaImage by the file's extension (.nii .nii.gz .nrrd .mha .mhd), compressed where the format allows.
// Atomic: a temporary file beside it, synced, then renamed. Throws WriteError naming the file.
void writeGrid(const std::filesystem::path& path, const GridGeometry& geometry,
               std::span<const std::uint8_t> values);
void writeGrid(const std::filesystem::path& path, const GridGeometry& geometry,
               std::span<const std::int16_t> values);
void writeGrid(const std::filesystem::path& path, const GridGeometry& geometry,
               std::span<const std::uint32_t> values);
void writeGrid(const std::filesystem::path& path, const GridGeometry& geometry,
               std::span<const float> values);
// Writes a grid of colours (sRGB) with opacity as NRRD, in the same way.
void writeColours(const std::filesystem::path& path, const GridGeometry& geometry,
                  std::span<const std::array<std::uint8_t, 4>> colours);
// Writes a volume's values in their own type.
void writeVolume(const std::filesystem::path& path, const Volume& volume);

} // namespace vs::volume
