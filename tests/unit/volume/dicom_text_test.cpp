// SPDX-License-Identifier: Apache-2.0
#include "volume/dicom/dicom_text.h"

#include "property.h"

#include <gtest/gtest.h>

namespace vs::volume {
namespace {

TEST(DicomText, IsReadInTheSetThatTheFileNames) {
    EXPECT_EQ(textIn("ISO_IR 100", "M\xfcller^J\xf6rg"), "Müller^Jörg");
    EXPECT_EQ(textIn("ISO_IR 192", "Müller"), "Müller");
    EXPECT_EQ(textIn("ISO_IR 144", "\xbb\xee\xda\x63"), "Люкc");
    EXPECT_EQ(textIn("", "Miller"), "Miller");
}

// A file may name a set that it does not use, or one that nobody knows.
TEST(DicomText, IsPrintableWhateverTheFileHolds) {
    EXPECT_EQ(textIn("", "M\xfcller"), "M?ller");
    EXPECT_EQ(textIn("ISO_IR 192", "M\xfcller"), "M?ller");
    EXPECT_EQ(textIn("EBCDIC", "M\xfcller"), "M?ller");
    EXPECT_EQ(textIn("ISO_IR 100", "a\nb\x1b[31m"), "a?b?[31m");
    test::checkProperty(200, [] {
        const auto bytes = *rc::gen::container<std::string>(rc::gen::arbitrary<char>());
        const auto set =
            *rc::gen::element<std::string>("", "ISO_IR 100", "ISO_IR 192", "ISO 2022 IR 6", "\\");
        for (const char c : textIn(set, bytes)) {
            const auto code = static_cast<unsigned char>(c);
            RC_ASSERT(code >= 0x20);
            RC_ASSERT(code != 0x7f);
        }
    });
}

TEST(DicomText, NamesAndDatesAreWrittenAsPeopleReadThem) {
    EXPECT_EQ(readablePersonName("Doe^Jane^Ann^Dr."), "Doe, Jane Ann Dr.");
    EXPECT_EQ(readablePersonName("Doe"), "Doe");
    EXPECT_EQ(readablePersonName("Doe^^Ann"), "Doe, Ann");
    EXPECT_EQ(readablePersonName("^Jane"), "Jane");
    EXPECT_EQ(readablePersonName("Yamada^Tarou=\xe5\xb1\xb1\xe7\x94\xb0"), "Yamada, Tarou");
    EXPECT_EQ(readablePersonName(""), "");
    EXPECT_EQ(readableDate("20240131"), "2024-01-31");
    EXPECT_EQ(readableDate("2024.01.31"), "");
    EXPECT_EQ(readableDate("yesterda"), "");
}

} // namespace
} // namespace vs::volume
