// SPDX-License-Identifier: Apache-2.0
// The encoding of DICOM files: PS3.5 chapter 7 and PS3.10 chapter 7.
#include "volume/dicom/dicom_elements.h"

#include "base/lines.h"
#include "volume/dicom/dicom.h"
#include "volume/io/inspect.h"

#include <fmt/format.h>
#include <zlib.h>

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace vs::volume {
namespace {

constexpr std::uint32_t undefinedLength = 0xFFFFFFFF;
constexpr std::uint32_t itemTag = 0xFFFEE000;
constexpr std::uint32_t itemEndTag = 0xFFFEE00D;
constexpr std::uint32_t sequenceEndTag = 0xFFFEE0DD;
constexpr std::uint32_t pixelDataTag = 0x7FE00010;

// Sequences that are looked into also where their representation is not written down (implicit transfer
// syntax).
constexpr std::uint32_t knownSequences[] = {0x52009229, 0x52009230, 0x00209113,
                                            0x00209116, 0x00289110, 0x00289145};
// Attributes that are kept; all others are only stepped over.
constexpr std::uint32_t keptElements[] = {
    0x00080005, 0x00080020, 0x00081030, 0x00100010, 0x00100020, 0x00200011,  0x00080008, 0x00080016,
    0x00080018, 0x00080060, 0x0008103E, 0x00180025, 0x00180050, 0x00180086,  0x00180088, 0x00181164,
    0x0020000E, 0x00200012, 0x00200013, 0x00200032, 0x00200037, 0x00200100,  0x00280002, 0x00280004,
    0x00280008, 0x00280010, 0x00280011, 0x00280030, 0x00280100, 0x00280101,  0x00280102, 0x00280103,
    0x00281052, 0x00281053, 0x00281054, 0x3004000C, 0x3004000E, pixelDataTag};

template <typename List>
bool contains(const List& list, std::uint32_t tag) {
    return std::find(std::begin(list), std::end(list), tag) != std::end(list);
}

struct Head {
    std::uint32_t tag = 0;
    std::array<char, 2> vr{};
    std::uint32_t length = 0;
    [[nodiscard]] bool hasVr(std::string_view name) const { return std::string_view(vr.data(), 2) == name; }
};

class Parser {
public:
    Parser(const std::filesystem::path& path, std::span<const unsigned char> bytes, std::size_t at)
        : path_(path), bytes_(bytes), at_(at) {}

    // The file meta information; returns the transfer syntax.
    std::string parseMeta() {
        std::string syntax;
        while (left(bytes_.size()) >= 8 && number(at_, 2) == 2) {
            const Head head = parseHead(bytes_.size());
            if (head.length == undefinedLength) {
                refuseElement(head, "has no length");
            }
            if (head.tag == 0x00020010) {
                syntax = trimmed({reinterpret_cast<const char*>(bytes_.data()) + at_, head.length});
            }
            at_ += head.length;
        }
        if (syntax.empty()) {
            refuse(path_, "its DICOM header names no transfer syntax", "get an intact copy of the file");
        }
        return syntax;
    }

    DicomDataSet parseDataSet(bool isExplicit, bool bigEndian) {
        explicit_ = isExplicit;
        bigEndian_ = bigEndian;
        if (left(bytes_.size()) == 0) {
            refuse(path_, "it ends with its DICOM header", "get a complete copy of the file");
        }
        return parseElements(bytes_.size(), 0);
    }
    [[nodiscard]] std::size_t at() const { return at_; }

private:
    [[noreturn]] void refuseElement(const Head& head, const std::string& wrong) const {
        refuse(path_,
               fmt::format("the DICOM element ({:04x},{:04x}) at byte {} {}", head.tag >> 16,
                           head.tag & 0xFFFF, at_, wrong),
               "the file is cut short or damaged");
    }

    [[nodiscard]] std::size_t left(std::size_t end) const { return end - at_; }
    [[nodiscard]] std::uint32_t number(std::size_t at, std::size_t count) const {
        std::uint32_t value = 0;
        for (std::size_t i = 0; i < count; ++i) {
            value = (value << 8) | bytes_[at + (bigEndian_ ? i : count - 1 - i)];
        }
        return value;
    }

    // Tag, value representation and length; the value lies before `end`.
    Head parseHead(std::size_t end) {
        Head head;
        if (left(end) < 8) {
            refuseElement(head, "is cut off");
        }
        head.tag = (number(at_, 2) << 16) | number(at_ + 2, 2);
        if (!explicit_ || head.tag >> 16 == 0xFFFE) {
            head.length = number(at_ + 4, 4);
            at_ += 8;
        } else {
            std::memcpy(head.vr.data(), bytes_.data() + at_ + 4, 2);
            constexpr std::string_view shortForms =
                "AE AS AT CS DA DS DT FL FD IS LO LT PN SH SL SS ST TM UI UL US ";
            constexpr std::string_view longForms = "OB OD OF OL OV OW SQ SV UC UN UR UT UV ";
            const auto isOneOf = [&](std::string_view forms) {
                const auto found = forms.find({head.vr.data(), 2});
                return found != std::string_view::npos && found % 3 == 0;
            };
            const bool isLong = isOneOf(longForms);
            if (!isLong && !isOneOf(shortForms)) {
                refuseElement(head, fmt::format("has the unknown value representation \"{}\"",
                                                printable({head.vr.data(), 2})));
            }
            if (isLong && left(end) < 12) {
                refuseElement(head, "is cut off");
            }
            head.length = isLong ? number(at_ + 8, 4) : number(at_ + 6, 2);
            at_ += isLong ? 12 : 8;
        }
        if (head.length != undefinedLength && head.length > left(end)) {
            refuseElement(head, fmt::format("claims {} bytes, {} are there", head.length, left(end)));
        }
        return head;
    }

    // Elements up to `end` or to the end mark of the item that they are in.
    DicomDataSet parseElements(std::size_t end, int depth) {
        DicomDataSet set;
        set.bigEndian = bigEndian_;
        while (at_ < end) {
            const Head head = parseHead(end);
            if (head.tag == itemEndTag && depth > 0) {
                return set;
            }
            DicomElement element;
            const bool known = contains(knownSequences, head.tag);
            if (head.length == undefinedLength && head.tag == pixelDataTag) {
                element.isEncapsulated = true;
                parseFragments(end, element);
            } else if (head.length == undefinedLength || head.hasVr("SQ") || (known && !explicit_)) {
                // A sequence of unknown representation holds implicit elements (PS3.5, 6.2.2).
                const bool wasExplicit = explicit_;
                explicit_ = explicit_ && !head.hasVr("UN");
                parseItems(head.length == undefinedLength ? end : at_ + head.length,
                           head.length == undefinedLength, depth + 1, element);
                explicit_ = wasExplicit;
            } else {
                element.value = bytes_.subspan(at_, head.length);
                at_ += head.length;
            }
            if (known || contains(keptElements, head.tag)) {
                set.elements.insert_or_assign(head.tag, std::move(element));
            }
        }
        return set;
    }

    void parseItems(std::size_t end, bool marked, int depth, DicomElement& sequence) {
        constexpr int deepest = 32; // real files stay below ten
        // An image of 10,000 frames has some 200,000, and pixels besides.
        const std::size_t mostItems = std::max<std::size_t>(1'000'000, bytes_.size() / 64);
        while (at_ < end) {
            const Head item = parseHead(end);
            if (item.tag == sequenceEndTag && marked) {
                return;
            }
            if (item.tag != itemTag || depth > deepest) {
                refuseElement(item, "stands where an item of a sequence belongs");
            }
            if (++items_ > mostItems) {
                refuseElement(item, fmt::format("is more than the {}th item", mostItems));
            }
            if (item.length == undefinedLength) {
                sequence.items.push_back(parseElements(end, depth));
            } else {
                const std::size_t itemEnd = at_ + item.length;
                sequence.items.push_back(parseElements(itemEnd, depth));
                at_ = itemEnd;
            }
        }
    }

    void parseFragments(std::size_t end, DicomElement& pixels) {
        bool isTable = true; // the first item is the table of offsets
        while (at_ < end) {
            const Head item = parseHead(end);
            if (item.tag == sequenceEndTag) {
                return;
            }
            if (item.tag != itemTag || item.length == undefinedLength) {
                refuseElement(item, "stands where a piece of compressed pixels belongs");
            }
            if (!isTable) {
                pixels.fragments.push_back(bytes_.subspan(at_, item.length));
            }
            isTable = false;
            at_ += item.length;
        }
    }

    const std::filesystem::path& path_;
    std::span<const unsigned char> bytes_;
    std::size_t at_ = 0;
    std::size_t items_ = 0;
    bool explicit_ = true;
    bool bigEndian_ = false;
};

std::span<const unsigned char> mapFile(const std::filesystem::path& path) {
    const std::size_t size = std::filesystem::file_size(path);
    const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
    void* start = file < 0 ? MAP_FAILED : mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file, 0);
    if (file >= 0) {
        close(file);
    }
    if (start == MAP_FAILED) {
        refuse(path, "it cannot be opened", "check its permissions");
    }
    return {static_cast<const unsigned char*>(start), size};
}

// Inflates elements that are deflated as a whole (PS3.5, A.5: a stream without header) piece by piece and
// gives each to `sink`.
template <typename Sink>
void forEachInflated(const std::filesystem::path& path, std::span<const unsigned char> bytes, Sink sink) {
    // Such files hold single images, which deflate packs by a few times; blank ones by more.
    const std::size_t most = std::max(std::size_t(128) << 20, 20 * bytes.size());
    std::vector<unsigned char> piece(1 << 16);
    std::size_t made = 0;
    z_stream stream{};
    stream.next_in = const_cast<unsigned char*>(bytes.data());
    stream.avail_in =
        static_cast<uInt>(std::min<std::size_t>(bytes.size(), std::numeric_limits<uInt>::max()));
    inflateInit2(&stream, -15);
    int status = Z_OK;
    while (status == Z_OK && made < most) {
        stream.next_out = piece.data();
        stream.avail_out = static_cast<uInt>(piece.size());
        status = inflate(&stream, Z_NO_FLUSH);
        const std::span<const unsigned char> fresh(piece.data(), piece.size() - stream.avail_out);
        made += fresh.size();
        sink(fresh);
    }
    inflateEnd(&stream);
    if (status == Z_OK) {
        refuse(path, fmt::format("its deflated elements expand beyond {} MB", most >> 20),
               "no image needs so much");
    }
    if (status != Z_STREAM_END) {
        refuse(path, "its deflated elements are damaged", "get an intact copy of the file");
    }
}

std::vector<unsigned char> inflateElements(const std::filesystem::path& path,
                                           std::span<const unsigned char> bytes) {
    using Piece = std::span<const unsigned char>;
    std::size_t size = 0; // counted first, so that a vector need not grow
    forEachInflated(path, bytes, [&](Piece piece) { size += piece.size(); });
    announcePromised(size);
    std::vector<unsigned char> result;
    result.reserve(size);
    forEachInflated(path, bytes,
                    [&](Piece piece) { result.insert(result.end(), piece.begin(), piece.end()); });
    return result;
}

} // namespace

const DicomElement* DicomDataSet::find(std::uint32_t tag) const {
    const auto found = elements.find(tag);
    return found == elements.end() ? nullptr : &found->second;
}

std::string DicomDataSet::text(std::uint32_t tag) const {
    const auto* element = find(tag);
    if (element == nullptr) {
        return {};
    }
    return trimmed({reinterpret_cast<const char*>(element->value.data()), element->value.size()});
}

std::vector<double> DicomDataSet::numbers(std::uint32_t tag) const {
    std::vector<double> values;
    for (const std::string& part : split(text(tag), '\\')) {
        double value = 0;
        if (!parseNumber(trimmed(part), value) || !std::isfinite(value)) {
            return {};
        }
        values.push_back(value);
    }
    return values;
}

int DicomDataSet::unsignedShort(std::uint32_t tag, int other) const {
    const auto* element = find(tag);
    if (element == nullptr || element->value.size() < 2) {
        return other;
    }
    const auto& bytes = element->value;
    return bigEndian ? bytes[0] * 256 + bytes[1] : bytes[1] * 256 + bytes[0];
}

DicomDocument::DicomDocument(const std::filesystem::path& path) : mapped_(mapFile(path)) {
    try {
        Parser meta(path, mapped_, 132); // behind the preamble and the letters DICM
        syntax_ = meta.parseMeta();
        const bool isExplicit = syntax_ != "1.2.840.10008.1.2";
        const bool bigEndian = syntax_ == "1.2.840.10008.1.2.2";
        if (syntax_ == "1.2.840.10008.1.2.1.99") {
            inflated_ = inflateElements(path, mapped_.subspan(meta.at()));
            root_ = Parser(path, inflated_, 0).parseDataSet(isExplicit, bigEndian);
        } else {
            root_ = Parser(path, mapped_, meta.at()).parseDataSet(isExplicit, bigEndian);
        }
    } catch (...) {
        munmap(const_cast<unsigned char*>(mapped_.data()), mapped_.size());
        throw;
    }
}

DicomDocument::~DicomDocument() { munmap(const_cast<unsigned char*>(mapped_.data()), mapped_.size()); }

bool hasDicomMark(const std::filesystem::path& path) {
    const auto start = readPrefix(path, 132);
    return start.size() == 132 && std::memcmp(start.data() + 128, "DICM", 4) == 0;
}

} // namespace vs::volume
