// SPDX-License-Identifier: Apache-2.0
// Values as they stand in files, byte for byte or as text: each is taken as it is or the file is refused.
#include "base/error.h"
#include "property.h"
#include "volume/dicom/coded_size.h"
#include "volume/io/decode.h"

#include "test_files.h"

#include <zlib.h>

#include <cmath>
#include <cstring>
#include <limits>

namespace vs::volume {
namespace {

std::string vtkText(const std::string& type, const std::string& values) {
    return "# vtk DataFile Version 3.0\nx\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 1 2 2\nSPACING 1 1 "
           "1\n"
           "ORIGIN 0 0 0\nPOINT_DATA 4\nSCALARS s " +
           type + " 1\nLOOKUP_TABLE default\n" + values + "\n";
}
std::string metaText(const std::string& type, const std::string& values) {
    return "ObjectType = Image\nNDims = 3\nDimSize = 1 2 2\nElementSpacing = 1 1 1\nBinaryData = False\n"
           "ElementType = MET_" +
           type + "\nElementDataFile = LOCAL\n" + values + "\n";
}
std::string nrrdText(const std::string& type, const std::string& values) {
    return "NRRD0004\ntype: " + type + "\ndimension: 3\nsizes: 1 2 2\nspacings: 1 1 1\nencoding: ascii\n\n" +
           values + "\n";
}

// The four values of a file, or none where it is refused.
std::vector<double> valuesOf(const std::filesystem::path& path) {
    try {
        const Volume volume = decodeVolume(path).volume;
        return {volume.at({0, 0, 0}), volume.at({0, 1, 0}), volume.at({0, 0, 1}), volume.at({0, 1, 1})};
    } catch (const ReadError& error) {
        EXPECT_NE(std::string(error.what()).find(path.filename().string()), std::string::npos);
        return {};
    }
}

struct TextFormat {
    const char* name;
    std::string (*text)(const std::string& type, const std::string& values);
    const char* floats;
    const char* shorts;
    const char* bytes; // unsigned
};
const TextFormat kTextFormats[] = {{"a.vtk", vtkText, "float", "short", "unsigned_char"},
                                   {"a.mha", metaText, "FLOAT", "SHORT", "UCHAR"},
                                   {"a.nrrd", nrrdText, "float", "short", "uchar"}};

TEST(StoredValues, TextOfFloats) {
    const TemporaryFolder folder;
    for (const TextFormat& format : kTextFormats) {
        writeFile(folder / format.name, format.text(format.floats, "1.5 nan -2e3\n\t7"));
        const auto values = valuesOf(folder / format.name);
        ASSERT_EQ(values.size(), 4U) << format.name;
        EXPECT_EQ(values[0], 1.5);
        EXPECT_TRUE(std::isnan(values[1]));
        EXPECT_EQ(values[2], -2000);
        EXPECT_EQ(values[3], 7) << "what stands behind a nan is as it was written";
        writeFile(folder / format.name, format.text(format.floats, "1 -inf inf 4"));
        EXPECT_EQ(valuesOf(folder / format.name)[2], std::numeric_limits<double>::infinity());
        for (const char* wrong :
             {"1 2 3 1e60", "1 2 3 4x", "1 2 three 4", "1 2 3", "1,2,3,4", "1 2 3 0x10g"}) {
            writeFile(folder / format.name, format.text(format.floats, wrong));
            EXPECT_TRUE(valuesOf(folder / format.name).empty()) << format.name << ": " << wrong;
        }
    }
}

TEST(StoredValues, TextOfIntegers) {
    const TemporaryFolder folder;
    for (const TextFormat& format : kTextFormats) {
        writeFile(folder / format.name, format.text(format.shorts, "-32768 32767 12.0 +3"));
        EXPECT_EQ(valuesOf(folder / format.name), (std::vector<double>{-32768, 32767, 12, 3})) << format.name;
        for (const char* wrong : {"1 2 3 1.5", "1 2 3 32768", "-32769 2 3 4", "1 nan 3 4", "1 2 inf 4"}) {
            writeFile(folder / format.name, format.text(format.shorts, wrong));
            EXPECT_TRUE(valuesOf(folder / format.name).empty()) << format.name << ": " << wrong;
        }
        writeFile(folder / format.name, format.text(format.bytes, "0 255 7 8"));
        EXPECT_EQ(valuesOf(folder / format.name), (std::vector<double>{0, 255, 7, 8})) << format.name;
        for (const char* wrong : {"0 256 7 8", "-1 2 3 4"}) {
            writeFile(folder / format.name, format.text(format.bytes, wrong));
            EXPECT_TRUE(valuesOf(folder / format.name).empty()) << format.name << ": " << wrong;
        }
    }
}

std::string deflated(const std::string& bytes) {
    uLongf size = compressBound(bytes.size());
    std::string out(size, '\0');
    compress(reinterpret_cast<Bytef*>(out.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
             bytes.size());
    out.resize(size);
    return out;
}

std::string metaOf(const std::string& fields, const std::string& data) {
    return "ObjectType = Image\nNDims = 3\nDimSize = 1 2 2\nElementType = MET_UCHAR\n" + fields +
           "ElementDataFile = LOCAL\n" + data;
}

// The library behind ITK's reader takes CompressedDataSize on trust, and leaves zeros where it is wrong.
TEST(StoredValues, CompressedMetaImages) {
    const TemporaryFolder folder;
    const std::vector<double> wanted{1, 2, 3, 4};
    const std::string data = deflated("\1\2\3\4");
    const auto sized = [&](std::size_t size) {
        return "CompressedData = True\nCompressedDataSize = " + std::to_string(size) + "\n";
    };
    writeFile(folder / "a.mha", metaOf("CompressedData = True\n", data));
    EXPECT_EQ(valuesOf(folder / "a.mha"), wanted);
    writeFile(folder / "a.mha", metaOf(sized(data.size()), data));
    EXPECT_EQ(valuesOf(folder / "a.mha"), wanted);
    writeFile(folder / "a.mha", metaOf(sized(data.size()), data + "and more"));
    EXPECT_EQ(valuesOf(folder / "a.mha"), wanted);
    for (const std::size_t wrong : {data.size() - 5, data.size() + 1, std::size_t(1)}) {
        writeFile(folder / "a.mha", metaOf(sized(wrong), data));
        EXPECT_TRUE(valuesOf(folder / "a.mha").empty()) << wrong;
    }
}

TEST(StoredValues, FieldsOfMetaImages) {
    const TemporaryFolder folder;
    for (const char* wrong :
         {"HeaderSize = 3\n", "elementspacing = 1 2 3\n", "ElementSpacing = 1 1 1\nElementSpacing = 2 2 2\n",
          "CompressedData = True\nHeaderSize = 2\n", "HeaderSize = 1.5\n", "compresseddata = True\n"}) {
        writeFile(folder / "a.mha", metaOf(wrong, "\1\2\3\4"));
        EXPECT_TRUE(valuesOf(folder / "a.mha").empty()) << wrong;
    }
    writeFile(folder / "a.mha", metaOf("HeaderSize = -1\nElementSpacing = 1 2 3\n", "xx\1\2\3\4"));
    EXPECT_EQ(valuesOf(folder / "a.mha"), (std::vector<double>{1, 2, 3, 4}));
}

// Both byte orders of every format that has them.
TEST(StoredValues, ByteOrders) {
    const TemporaryFolder folder;
    const std::vector<double> wanted{258, 2, 3, -2};
    const std::string big("\1\2\0\2\0\3\377\376", 8);
    const std::string little("\2\1\2\0\3\0\376\377", 8);
    for (const bool isBig : {false, true}) {
        const std::string data = isBig ? big : little;
        writeFile(folder / "a.nrrd",
                  "NRRD0004\ntype: short\ndimension: 3\nsizes: 1 2 2\nspacings: 1 1 1\nendian: " +
                      std::string(isBig ? "big" : "little") + "\nencoding: raw\n\n" + data);
        EXPECT_EQ(valuesOf(folder / "a.nrrd"), wanted);
        for (const char* field : {"ElementByteOrderMSB", "BinaryDataByteOrderMSB"}) {
            writeFile(folder / "a.mha",
                      "ObjectType = Image\nNDims = 3\nDimSize = 1 2 2\nBinaryData = True\n" +
                          std::string(field) + (isBig ? " = True" : " = False") +
                          "\nElementType = MET_SHORT\nElementDataFile = LOCAL\n" + data);
            EXPECT_EQ(valuesOf(folder / "a.mha"), wanted) << field;
        }
    }
    std::string vtk = vtkText("short", "");
    vtk.replace(vtk.find("ASCII"), 5, "BINARY");
    vtk.pop_back();
    writeFile(folder / "a.vtk", vtk + big);
    EXPECT_EQ(valuesOf(folder / "a.vtk"), wanted);
}

std::vector<unsigned char> runLengths(const std::vector<std::vector<unsigned char>>& segments) {
    std::vector<unsigned char> frame(64);
    frame[0] = static_cast<unsigned char>(segments.size());
    for (std::size_t i = 0; i < segments.size(); ++i) {
        for (std::size_t byte = 0; byte < 4; ++byte) {
            frame[4 + 4 * i + byte] = static_cast<unsigned char>(frame.size() >> (8 * byte));
        }
        frame.insert(frame.end(), segments[i].begin(), segments[i].end());
    }
    return frame;
}

// Rows as DICOM wants them: no run goes on in the next row.
std::vector<unsigned char> evenRows(int columns, int rows) {
    std::vector<unsigned char> runs;
    for (int row = 0; row < rows; ++row) {
        for (int left = columns; left > 0; left -= 128) {
            const int run = std::min(left, 128);
            runs.push_back(static_cast<unsigned char>(run > 1 ? 257 - run : 0));
            runs.push_back(static_cast<unsigned char>(row));
        }
    }
    return runs;
}

TEST(StoredValues, RunLengthsHaveTheirImagesRows) {
    test::checkProperty(100, [] {
        const int columns = *rc::gen::inRange(10, 120);
        const int rows = *rc::gen::inRange(4, 60);
        auto runs = evenRows(columns, rows);
        const auto is = [&](glm::ivec2 size, std::size_t bytes) {
            return isRunLengthOf(runLengths({runs}), size, bytes);
        };
        RC_ASSERT(is({columns, rows}, 1));
        RC_ASSERT(!is({columns, rows}, 2));
        RC_ASSERT(!is({columns, rows + 1}, 1));
        RC_ASSERT(!is({columns, rows - 1}, 1));
        RC_ASSERT(!is({columns + 1, rows}, 1));
        if (columns % 3 == 0 && columns / 3 >= 4) {
            RC_ASSERT(!is({columns / 3, rows * 3}, 1));
        }
        for (const unsigned char filler : {0, 0, 0, 128}) { // an odd length is made even so, or one of fours
            runs.push_back(filler);
            RC_ASSERT(is({columns, rows}, 1));
        }
    });
    // Runs that do not care about rows are read: the standard forbids them, and some programs write them.
    std::vector<unsigned char> careless;
    for (int i = 0, left = 64 * 75; left > 0; ++i) {
        const int run = std::min(left, 80 + i * 37 % 41);
        careless.insert(careless.end(), {static_cast<unsigned char>(run > 1 ? 257 - run : 0), 7});
        left -= run;
    }
    EXPECT_TRUE(isRunLengthOf(runLengths({careless}), {64, 75}, 1));
    const std::vector<unsigned char> even(2 * 192 * 192 / 128, 129); // runs of 128 as long as they can be
    EXPECT_TRUE(isRunLengthOf(runLengths({even}), {192, 192}, 1));
    EXPECT_FALSE(isRunLengthOf({}, {64, 75}, 1));
}

TEST(StoredValues, CompressedImagesSayTheirSize) {
    const std::vector<unsigned char> jpeg{0xFF, 0xD8, 0xFF, 0xE0, 0, 4, 1, 2, 0xFF, 0xFF,
                                          0xC3, 0,    11,   8,    1, 0, 2, 0, 1};
    EXPECT_EQ(codedSize(jpeg), glm::ivec2(512, 256));
    std::vector<unsigned char> jpeg2000{0xFF, 0x4F, 0xFF, 0x51, 0, 41, 0, 0};
    const auto add = [&](unsigned number) {
        for (int shift = 24; shift >= 0; shift -= 8) {
            jpeg2000.push_back(static_cast<unsigned char>(number >> shift));
        }
    };
    add(70);
    add(90);
    add(6);
    add(10);
    EXPECT_EQ(codedSize(jpeg2000), glm::ivec2(64, 80));
    std::vector<unsigned char> boxed{0, 0, 0, 12, 'j', 'P', ' ', ' ', 13, 10, 135, 10};
    boxed.insert(boxed.end(), jpeg2000.begin(), jpeg2000.end());
    EXPECT_EQ(codedSize(boxed), glm::ivec2(64, 80));
    test::checkProperty(300, [&] { // cut anywhere it says nothing, and reads nothing beyond
        const auto& whole = *rc::gen::inRange(0, 2) == 0 ? jpeg : jpeg2000;
        const std::vector<unsigned char> part(whole.begin(),
                                              whole.begin() + *rc::gen::inRange(0, int(whole.size())));
        RC_ASSERT(!codedSize(part) || codedSize(part) == codedSize(whole));
    });
}

} // namespace
} // namespace vs::volume
