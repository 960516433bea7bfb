// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/error.h"
#include "volume/io/read.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

// Inspection of headers before anything is allocated or given to a library. Internal to this folder.
namespace vs::volume {

// The types that values have in files; 64-bit ones become Float32 here.
enum class StoredType { UInt8, Int8, UInt16, Int16, UInt32, Int32, UInt64, Int64, Float32, Float64 };
std::uint64_t bytesOf(StoredType type);

enum class Encoding { Raw, Deflated, Ascii };

// Where the values of a file lie, and what they are.
struct DataBlock {
    std::filesystem::path file;
    std::uint64_t offset = 0; // where the block starts
    Encoding encoding = Encoding::Raw;
    StoredType type = StoredType::UInt8;
    bool isBigEndian = false;
    std::uint64_t count = 0;      // of values
    std::uint64_t before = 0;     // bytes of the (inflated) block before the first value
    std::uint64_t mostStored = 0; // bytes that it takes in the file at most; 0: up to its end

    // The values that a deflated block holds, where they were kept when it was checked: inflating takes most
    // of reading.
    std::shared_ptr<std::vector<std::byte>> inflated = {};

    [[nodiscard]] std::uint64_t bytes() const { return before + count * bytesOf(type); }
};

// Whether what is inflated for a check is kept, for readValues() soon afterwards.
enum class Inflated { Dropped, Kept };

// What a header promises, checked against the file that should hold it.
struct Inspection {
    std::vector<std::int64_t> sizes; // fastest axis first; three, or four when the last counts frames
    std::vector<std::string> notices;
    DataBlock block;

    [[nodiscard]] glm::ivec3 dims() const { return {int(sizes.at(0)), int(sizes.at(1)), int(sizes.at(2))}; }
};

// A file that holds many volumes keeps nothing: one of them is read.
inline Inflated keptOf(const Inspection& inspection, Inflated inflated) {
    return inspection.sizes.size() > 3 && inspection.sizes[3] > 1 ? Inflated::Dropped : inflated;
}

// Refuses a file: throws ReadError "FILE: what is wrong; what would be right".
[[noreturn]] void refuse(const std::filesystem::path& path, std::string_view wrong, std::string_view right);

// The text with unprintable characters replaced and cut to a length that fits a message.
std::string printable(std::string_view text);
std::string lowerCase(std::string_view text);
std::string trimmed(std::string_view text);
// Whether the whole text is one number. Unlike streams it reads "nan", so that a check can refuse it.
bool parseNumber(const std::string& text, double& value);
// The numbers of a blank-separated list; refuses what is not a number. `what` names the field.
std::vector<double> parseNumbers(const std::filesystem::path& path, std::string_view what,
                                 const std::string& text);

// What is heard of the sizes that headers state, by who limits memory and time: the bytes of voxels that one
// promises, when checkedBytes() has found them to be sound, and those of another file that it names.
struct SizeListener {
    std::function<void(std::uint64_t bytes)> promised;
    std::function<void(std::uint64_t bytes)> stored;
};
void listenToSizes(SizeListener listener);
void announcePromised(std::uint64_t bytes);
void announceStored(std::uint64_t bytes);
// The product of sizes and bytesPerVoxel. Refuses sizes below 1, products that overflow or exceed the
// machine's memory.
std::uint64_t checkedBytes(const std::filesystem::path& path, const std::vector<std::int64_t>& sizes,
                           std::uint64_t bytesPerVoxel);
// Refuses spacings that are zero, negative, not finite or absurd.
void checkSpacing(const std::filesystem::path& path, double spacing);
// Refuses geometries that are not finite or squash space.
void checkGeometry(const std::filesystem::path& path, const GridGeometry& geometry);
// Refuses a block that is missing, shorter than promised, corrupt, or that expands beyond its promise; of
// text also what is no number, or none of the type: a fraction among integers, one that is too large.
// Trailing bytes of an uncompressed block give a notice.
void checkDataBlock(const std::filesystem::path& path, DataBlock& block, std::vector<std::string>& notices,
                    Inflated inflated = Inflated::Dropped);
// The values of a block that was checked, `count` of them behind the first `skip`, in this machine's byte
// order. Takes what was kept.
std::vector<std::byte> readValues(DataBlock& block, std::uint64_t skip, std::uint64_t count);
// The number of the volume to read of a file that holds `frames`; refuses with the choices where that is not
// clear.
int chosenFrame(const std::filesystem::path& path, std::int64_t frames, std::optional<int> frame);
// The number of the channel to read; `names` is told where there are several: " 0 DAPI, 1 GFP".
int chosenChannel(const std::filesystem::path& path, int channels, std::optional<int> channel,
                  const std::string& names);
// The file that a header names beside itself. Refuses absolute names, those that leave the folder, and
// missing files.
std::filesystem::path siblingFile(const std::filesystem::path& header, const std::string& name);

// First bytes of a file, as they are or of what is deflated in it; fewer if there are not so many.
std::vector<unsigned char> readPrefix(const std::filesystem::path& path, std::size_t count);
std::vector<unsigned char> inflatedPrefix(const std::filesystem::path& path, std::size_t count);
bool hasGzipMagic(const std::filesystem::path& path);

struct PlacedInspection : Inspection {
    GridGeometry geometry;
};

struct NiftiInspection : PlacedInspection {
    double slope = 1; // 1 and 0 where the header asks for no scaling
    double intercept = 0;
};

// Inspect a file's header, one function for each format. Each refuses what does not fit and returns what
// does.
NiftiInspection inspectNifti(const std::filesystem::path& path, Inflated inflated = Inflated::Dropped);
Inspection inspectNrrd(const std::filesystem::path& path, Inflated inflated = Inflated::Dropped);
Inspection inspectMeta(const std::filesystem::path& path, Inflated inflated = Inflated::Dropped);
PlacedInspection inspectVtk(const std::filesystem::path& path);

} // namespace vs::volume
