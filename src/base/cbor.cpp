// SPDX-License-Identifier: Apache-2.0
#include "base/cbor.h"

#include "base/error.h"

namespace vs {
namespace {

// Hears of everything that a message holds, and stops reading where it is too deep: the library reads what is
// nested by calling itself, without end where that has none.
class DepthCheck : public nlohmann::json_sax<nlohmann::json> {
public:
    bool null() override { return true; }
    bool boolean(bool) override { return true; }
    bool number_integer(number_integer_t) override { return true; }
    bool number_unsigned(number_unsigned_t) override { return true; }
    bool number_float(number_float_t, const string_t&) override { return true; }
    bool string(string_t&) override { return true; }
    bool binary(binary_t&) override { return true; }
    bool key(string_t&) override { return true; }
    bool start_object(std::size_t) override { return deeper(); }
    bool start_array(std::size_t) override { return deeper(); }
    bool end_object() override { return higher(); }
    bool end_array() override { return higher(); }
    bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception&) override {
        return false;
    }

private:
    static constexpr int kDeepest = 20; // ours have six levels

    bool deeper() { return ++depth_ <= kDeepest; }
    bool higher() {
        --depth_;
        return true;
    }

    int depth_ = 0;
};

} // namespace

nlohmann::json fromCbor(std::span<const std::uint8_t> bytes) {
    DepthCheck check;
    try {
        if (nlohmann::json::sax_parse(bytes.begin(), bytes.end(), &check,
                                      nlohmann::json::input_format_t::cbor)) {
            return nlohmann::json::from_cbor(bytes.begin(), bytes.end());
        }
    } catch (const nlohmann::json::exception&) { // its words about bytes say nothing to people
    }
    throw Error("a message that is none");
}

} // namespace vs
