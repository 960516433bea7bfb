// SPDX-License-Identifier: Apache-2.0
// Files that are not what they claim are refused in one line that names them.
#include "base/error.h"
#include "property.h"
#include "volume/io/decode.h"
#include "volume/io/write.h"

#include "test_files.h"

#include <optional>
#include <random>

namespace vs::volume {
namespace {

std::string refusal(const std::filesystem::path& path, const ReadOptions& options = {}) {
    try {
        decodeVolume(path, options);
    } catch (const ReadError& error) {
        std::string text = error.what();
        EXPECT_NE(text.find(path.filename().string()), std::string::npos) << text;
        EXPECT_EQ(text.find('\n'), std::string::npos) << text;
        EXPECT_NE(text.find("; "), std::string::npos) << "no word of what would be right: " << text;
        return text;
    }
    ADD_FAILURE() << path << " was read";
    return {};
}

std::string nrrd(const std::string& fields, const std::string& data = "12345678") {
    return "NRRD0004\n" + fields + "\n" + data;
}

TEST(Malformed, FilesThatAreSomethingElse) {
    const TemporaryFolder folder;
    for (const char* name :
         {"a.nii", "a.nii.gz", "a.nrrd", "a.nhdr", "a.mha", "a.mhd", "a.vtk", "a.dcm", "a", "a.txt"}) {
        writeFile(folder / name, "");
        EXPECT_NE(refusal(folder / name).find("empty"), std::string::npos);
        writeFile(folder / name, "just a few words\nin two lines\n");
        refusal(folder / name);
        writeFile(folder / name, std::string(5000, '\xA5'));
        refusal(folder / name);
    }
    refusal(folder / "missing.nrrd");
    refusal(folder.path());
    std::filesystem::create_directory(folder / "empty_folder");
    refusal(folder / "empty_folder");
    writeFile(folder / "a.raw", "12345678");
    EXPECT_NE(refusal(folder / "a.raw").find("--raw"), std::string::npos);
}

TEST(Malformed, NrrdFields) {
    const TemporaryFolder folder;
    const std::string good = "type: uint8\ndimension: 3\nsizes: 2 2 2\nspacings: 1 1 1\nencoding: raw\n";
    writeFile(folder / "good.nrrd", nrrd(good));
    EXPECT_NO_THROW(decodeVolume(folder / "good.nrrd"));
    const std::pair<const char*, const char*> changes[] = {
        {"2 2 2", "2 2 3"},
        {"2 2 2", "2 2"},
        {"2 2 2", "2 -2 2"},
        {"2 2 2", "0 2 2"},
        {"2 2 2", "2.5 2 2"},
        {"2 2 2", "2 2 99999999999999999999"},
        {"2 2 2", "65536 65536 65536"},
        {"2 2 2", "a b c"},
        {"2 2 2", "nan nan nan"},
        {"uint8", "uint80"},
        {"uint8", "block"},
        {"uint8", "double"},
        {"raw", "gzip"},
        {"raw", "bzip2"},
        {"raw", "ascii"},
        {"dimension: 3", "dimension: 4"},
        {"1 1 1", "1 0 1"},
        {"1 1 1", "1 -1 1"},
        {"1 1 1", "1 inf 1"},
        {"1 1 1", "1 1"},
        {"type: uint8", "kind: uint8"},
        {"type: uint8\n", "type: int16\n"},
        {"spacings: 1 1 1", "space directions: (1,0,0) (0,1,0) (1,1,0)"},
        {"spacings: 1 1 1", "kinds: RGB-color domain domain"},
        {"raw", "raw\ndata file: /etc/hostname"},
        {"raw", "raw\ndata file: ../x.raw"},
        {"raw", "raw\nbyte skip: 5"},
        {"raw", "raw\nline skip: -3"},
        {"raw", "raw\nflavour: sweet"}};
    for (const auto& [from, to] : changes) {
        std::string fields = good;
        fields.replace(fields.find(from), std::string(from).size(), to);
        writeFile(folder / "bad.nrrd", nrrd(fields));
        refusal(folder / "bad.nrrd");
    }
}

// A library that formats its complaint into a buffer of fixed length must not come to see them.
TEST(Malformed, LongNrrdFields) {
    const TemporaryFolder folder;
    const std::string good = "type: uint8\ndimension: 3\nsizes: 2 2 2\nencoding: raw\n";
    for (const std::string name :
         {"space", "units", "labels", "kinds", "centers", "thicknesses", "axis mins", "old min", "min",
          "number", "block size", "sample units", "space units", "measurement frame", "endian", "flavour"}) {
        for (const char* letter : {"a", "9", "\"", "(", " "}) {
            std::string fields = good;
            fields.append(name).append(": ");
            for (int i = 0; i < 5000; ++i) {
                fields += letter;
            }
            writeFile(folder / "long.nrrd", nrrd(fields + ".\n"));
            EXPECT_NE(refusal(folder / "long.nrrd").find(name), std::string::npos);
        }
    }
    const std::string text(5000, 'a');
    std::string fields = good;
    fields.append("content: ").append(text).append("\nnote:=").append(text).append("\n");
    writeFile(folder / "content.nrrd", nrrd(fields));
    EXPECT_EQ(decodeVolume(folder / "content.nrrd").volume.geometry.dims, glm::ivec3(2));
}

TEST(Malformed, DataFileMayNotBeALinkOutOfTheFolder) {
    const TemporaryFolder folder;
    const TemporaryFolder elsewhere;
    writeFile(elsewhere / "data.raw", "12345678");
    std::filesystem::create_symlink(elsewhere / "data.raw", folder / "data.raw");
    writeFile(folder / "a.nhdr",
              "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 2 2 2\nencoding: raw\ndata file: data.raw\n");
    EXPECT_NE(refusal(folder / "a.nhdr").find("outside"), std::string::npos);
}

TEST(Malformed, RawFilesOfAnotherSize) {
    const TemporaryFolder folder;
    ReadOptions options;
    options.raw = parseRawLayout("2x2x2:uint8");
    for (const char* content : {"1234567", "123456789", ""}) {
        writeFile(folder / "a.raw", content);
        const auto text = refusal(folder / "a.raw", options);
        EXPECT_NE(text.find(std::to_string(std::string(content).size())), std::string::npos)
            << "found: " << text;
        EXPECT_NE(text.find('8'), std::string::npos) << "expected: " << text;
    }
}

// The content of a whole file in a format.
std::string wholeFile(const std::filesystem::path& path) {
    const GridGeometry grid = makeGeometry({9, 8, 7}, {1, 2, 3});
    std::vector<std::uint8_t> values(grid.voxelCount());
    std::mt19937 random(7);
    for (auto& value : values) {
        value = std::uint8_t(random());
    }
    writeGrid(path, grid, std::span<const std::uint8_t>(values));
    return readFile(path);
}

// What a read error says when a file is refused; nothing when it was read.
std::optional<std::string> refused(const std::filesystem::path& path) {
    try {
        RC_ASSERT(!decodeVolume(path).volume.bytes.empty());
        return std::nullopt;
    } catch (const ReadError& error) {
        return error.what();
    }
}

class Damaged : public testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Formats, Damaged, testing::Values("a.nii.gz", "a.nii", "a.nrrd", "a.mha"),
                         [](const auto& instance) {
                             std::string name = std::string(instance.param).substr(2);
                             std::erase(name, '.');
                             return name;
                         });

// Truncated at any length a file is refused.
TEST_P(Damaged, TruncatedFilesAreRefused) {
    const TemporaryFolder folder;
    const auto path = folder / GetParam();
    const std::string whole = wholeFile(path);
    test::checkProperty(50, [&] {
        writeFile(path, whole.substr(0, std::size_t(*test::below(int(whole.size())))));
        const auto text = refused(path);
        RC_ASSERT(text.has_value());
        RC_ASSERT(text->find(path.filename().string()) != std::string::npos);
        RC_ASSERT(text->find('\n') == std::string::npos);
        RC_ASSERT(text->find("; ") != std::string::npos);
    });
}

// With other bytes in its header it is read or refused, never worse.
TEST_P(Damaged, FilesNeverCrash) {
    const TemporaryFolder folder;
    const auto path = folder / GetParam();
    const std::string whole = wholeFile(path);
    const auto change =
        rc::gen::pair(test::below(int(std::min<std::size_t>(whole.size(), 352))), test::below(256));
    test::checkProperty(100, [&] {
        std::string damaged = whole;
        for (const auto& [place, byte] : *rc::gen::container<std::vector<std::pair<int, int>>>(3, change)) {
            damaged[std::size_t(place)] = char(byte);
        }
        writeFile(path, damaged);
        const auto text = refused(path);
        RC_ASSERT((!text || text->find('\n') == std::string::npos));
    });
}

} // namespace
} // namespace vs::volume
