// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace vs::volume {

struct DicomElement;

// Elements by tag (group in the upper 16 bits), as far as reading a volume needs them.
struct DicomDataSet {
    std::map<std::uint32_t, DicomElement> elements;
    bool bigEndian = false;

    [[nodiscard]] const DicomElement* find(std::uint32_t tag) const;
    // The value as text without padding; empty if there is none.
    [[nodiscard]] std::string text(std::uint32_t tag) const;
    // Numbers written as text, separated by backslashes; nothing if one of them is not a finite number.
    [[nodiscard]] std::vector<double> numbers(std::uint32_t tag) const;
    // A 16-bit unsigned number, `other` if there is none.
    [[nodiscard]] int unsignedShort(std::uint32_t tag, int other) const;
};

struct DicomElement {
    std::span<const unsigned char> value;                  // points into the document
    std::vector<DicomDataSet> items;                       // of a sequence
    bool isEncapsulated = false;                           // compressed pixels
    std::vector<std::span<const unsigned char>> fragments; // of compressed pixels, offset table left out
};

// A DICOM file's elements, read by our own parser: it only ever looks, so that lengths which the file cannot
// hold are refused before a library allocates by them, and it cannot be brought to stop the program as GDCM's
// can.
class DicomDocument {
public:
    // Reads a file's elements. Throws ReadError if the structure is damaged.
    explicit DicomDocument(const std::filesystem::path& path);
    ~DicomDocument();
    DicomDocument(const DicomDocument&) = delete;
    DicomDocument& operator=(const DicomDocument&) = delete;

    [[nodiscard]] const DicomDataSet& root() const { return root_; }
    // The UID that says how elements and pixels are encoded.
    [[nodiscard]] const std::string& transferSyntax() const { return syntax_; }

private:
    std::span<const unsigned char> mapped_;
    std::vector<unsigned char> inflated_; // the elements, where the file holds them deflated
    std::string syntax_;
    DicomDataSet root_;
};

} // namespace vs::volume
