// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/error.h"
#include "base/text.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <span>
#include <string>

namespace vs {

// Reads one JSON value and knows where it stands, so that every complaint names the place: "head.json:
// operation 3: mask.points[7]: must be a number". Throws SessionError.
class JsonReader {
public:
    using Json = nlohmann::ordered_json;

    JsonReader(const Json& json, std::string where, std::string path = "")
        : json_(json), where_(std::move(where)), path_(std::move(path)) {}

    // `wanted` may quote the file, which may hold anything.
    [[noreturn]] void fail(const std::string& wanted) const {
        constexpr std::size_t longest = 2000;
        throw SessionError("{}: {}{}{}", where_, path_, path_.empty() ? "" : ": ",
                           readableName(wanted, longest));
    }

    // Fails about what lies further inside: "points[1].at", or "" for this value.
    [[noreturn]] void failAt(const std::string& place, const std::string& wanted) const {
        const std::string separator = path_.empty() || place.empty() ? "" : ".";
        JsonReader(json_, where_, path_ + separator + place).fail(wanted);
    }

    [[nodiscard]] JsonReader member(const char* key) const {
        expectObject();
        if (!json_.contains(key)) {
            fail(std::string("the member '") + key + "' is missing");
        }
        return {json_.at(key), where_, path_.empty() ? key : path_ + "." + key};
    }

    template <typename F>
    void ifHas(const char* key, F&& read) const {
        expectObject();
        if (json_.contains(key)) {
            read(member(key));
        }
    }

    [[nodiscard]] bool has(const char* key) const {
        expectObject();
        return json_.contains(key);
    }

    // Complains about members that mean nothing here: a misspelt one must not be ignored.
    void allow(std::initializer_list<const char*> keys) const {
        allow(std::span<const char* const>(keys.begin(), keys.size()));
    }
    void allow(std::span<const char* const> keys) const {
        expectObject();
        for (const auto& item : json_.items()) {
            if (std::find(keys.begin(), keys.end(), item.key()) == keys.end()) {
                std::string all;
                for (const char* key : keys) {
                    all += std::string(all.empty() ? "" : ", ") + key;
                }
                fail("the member '" + item.key() + "' is not known here; known are " + all);
            }
        }
    }

    [[nodiscard]] bool isNull() const { return json_.is_null(); }
    [[nodiscard]] bool isText() const { return json_.is_string(); }
    // The value itself and what complaints about it begin with, for a reader of its own.
    [[nodiscard]] const Json& json() const { return json_; }
    [[nodiscard]] std::string place() const { return path_.empty() ? where_ : where_ + ": " + path_; }

    [[nodiscard]] std::size_t size() const {
        if (!json_.is_array()) {
            fail("must be a list");
        }
        return json_.size();
    }

    void expectSize(std::size_t wanted) const {
        if (size() != wanted) {
            fail("must be a list of " + std::to_string(wanted) + " numbers");
        }
    }

    [[nodiscard]] JsonReader at(std::size_t index) const {
        if (index >= size()) {
            fail("must have at least " + std::to_string(index + 1) + " entries");
        }
        return {json_.at(index), where_, path_ + "[" + std::to_string(index) + "]"};
    }

    [[nodiscard]] double number() const {
        if (!json_.is_number() || !std::isfinite(json_.get<double>())) {
            fail("must be a number");
        }
        return json_.get<double>();
    }

    [[nodiscard]] double numberBetween(double lo, double hi) const {
        const double value = number();
        if (value < lo || value > hi) {
            fail(fmt::format("{} is out of bounds; {} to {} is allowed", value, lo, hi));
        }
        return value;
    }

    [[nodiscard]] long integerBetween(long lo, long hi) const {
        if (!json_.is_number_integer()) {
            fail("must be a whole number");
        }
        // Compared as what they are: a double does not hold all of them.
        const bool isBeyond = json_.is_number_unsigned() &&
                              json_.get<std::uint64_t>() > std::uint64_t(std::numeric_limits<long>::max());
        const long value = isBeyond ? 0 : json_.get<long>();
        if (isBeyond || value < lo || value > hi) {
            fail(fmt::format("{} is out of bounds; {} to {} is allowed", json_.dump(), lo, hi));
        }
        return value;
    }

    [[nodiscard]] bool boolean() const {
        if (!json_.is_boolean()) {
            fail("must be true or false");
        }
        return json_.get<bool>();
    }

    [[nodiscard]] std::string text() const {
        if (!json_.is_string()) {
            fail("must be a text");
        }
        return json_.get<std::string>();
    }

    // The name of a file or folder: JSON texts can be what no name is.
    [[nodiscard]] std::string fileName() const {
        std::string value = text();
        if (value.empty() || value.find('\0') != std::string::npos) {
            fail("must be the name of a file or folder");
        }
        return value;
    }

    // Reads a text that is one of the names, as the enumerator of the same place.
    template <typename Enum, std::size_t N>
    [[nodiscard]] Enum choice(const std::array<const char*, N>& names) const {
        return static_cast<Enum>(indexAmong(names));
    }
    // Reads a text that is one of the names, and gives its place: for texts that no enum stands behind.
    [[nodiscard]] std::size_t indexAmong(std::span<const char* const> names) const {
        const std::string value = text();
        std::string all;
        for (std::size_t i = 0; i < names.size(); ++i) {
            if (value == names[i]) {
                return i;
            }
            all += std::string(all.empty() ? "" : ", ") + names[i];
        }
        fail("'" + value + "' is not known; choose one of " + all);
    }

private:
    void expectObject() const {
        if (!json_.is_object()) {
            fail("must be an object");
        }
    }

    const Json& json_;
    std::string where_;
    std::string path_;
};

} // namespace vs
