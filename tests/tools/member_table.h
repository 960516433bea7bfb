// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "described_schema.h"

#include <utility>

namespace vs {

// What the members of described structs may be, as a table in Markdown.
class MemberTable {
public:
    // Adds all fields of T, with `owner` in the column that says whose they are.
    template <typename T>
    void add(const std::string& owner) {
        if constexpr (isFile<T>) {
            addRow({T::kFormat.member, "`" + std::to_string(T::kFormat.version) + "`", "needed",
                    "version of the format"},
                   owner);
        }
        addFields<T>(T::fields(), "", owner);
    }

    [[nodiscard]] std::string markdown() const;

private:
    struct Row {
        std::string name;
        std::string value;
        std::string byDefault;
        std::string meaning;

        auto operator<=>(const Row&) const = default;
    };

    // The owner joins those of the same member.
    void addRow(const Row& row, const std::string& owner);

    template <typename T, typename Fields>
    void addFields(const Fields& fields, const std::string& prefix, const std::string& owner);
    template <typename T, typename F>
    static Row rowOf(const F& field, const std::string& prefix);

    std::vector<std::pair<Row, std::vector<std::string>>> rows_;
};

// What a value may be, in words, by its schema.
std::string inWords(const Json& schema);

// In which of its struct's variants a field means something: " (`helix`; without `colourMap`)", "" for all.
template <typename T, typename F>
std::string whereIn(const F& field) {
    const std::vector<T> variants = variantsOf<T>();
    std::string all;
    forEachField(T::fields(), [&]<typename D>(const D& deciding) {
        if (!deciding.decides || std::string_view(deciding.name) == field.name) {
            return;
        }
        // What the deciding field is where the other one means something, and anywhere it could decide.
        std::vector<std::string> here;
        std::vector<std::string> anywhere;
        const auto add = [](std::vector<std::string>& texts, const std::string& text) {
            if (std::find(texts.begin(), texts.end(), text) == texts.end()) {
                texts.push_back(text);
            }
        };
        for (const T& variant : variants) {
            std::string text;
            if constexpr (Named<ValueOf<T, D>>) {
                text = std::string("`") + nameOf(valueOf(variant, deciding.access)) + "`";
            } else if constexpr (isOptional<ValueOf<T, D>>) {
                text = std::string(valueOf(variant, deciding.access) ? "with `" : "without `") +
                       deciding.name + "`";
            }
            if (isIn(variant, deciding)) {
                add(anywhere, text);
            }
            if (isIn(variant, field)) {
                add(here, text);
            }
        }
        const bool decidesHere = here.size() < anywhere.size() &&
                                 std::any_of(variants.begin(), variants.end(),
                                             [&](const T& v) { return isIn(v, field) && isIn(v, deciding); });
        if (decidesHere) {
            all += all.empty() ? "" : "; ";
            for (std::size_t i = 0; i < here.size(); ++i) {
                all += (i > 0 ? ", " : "") + here[i];
            }
        }
    });
    return all.empty() ? "" : " (" + all + ")";
}

template <typename T, typename Fields>
void MemberTable::addFields(const Fields& fields, const std::string& prefix, const std::string& owner) {
    forEachField(fields, [&]<typename F>(const F& field) {
        if constexpr (F::kPresence == Presence::Group) {
            addFields<T>(field.inner, std::string(field.name) + ".", owner);
        } else if constexpr (F::kPresence == Presence::Spread) {
            addFields<ValueOf<T, F>>(ValueOf<T, F>::fields(), prefix, owner);
        } else {
            addRow(rowOf<T>(field, prefix), owner + whereIn<T>(field));
        }
    });
}

template <typename T, typename F>
MemberTable::Row MemberTable::rowOf(const F& field, const std::string& prefix) {
    const T byDefault{};
    Json ignored = Json::object();
    const Json value = write(valueOf(byDefault, field.access), field.rule);
    const bool isNeeded = F::kPresence == Presence::Required;
    const bool hasDefault = !isNeeded && value.is_primitive() && !value.is_null() &&
                            value != ""; // NOLINT(readability-container-size-empty): 0 is not empty text
    std::string text = inWords(schemaOf(Type<ValueOf<T, F>>(), field.rule, ignored));
    if (*field.rule.unit != '\0') {
        text += std::string(", ") + field.rule.unit;
    }
    return {prefix + field.name, text,
            isNeeded     ? "needed"
            : hasDefault ? "`" + value.dump() + "`"
                         : "",
            field.meaning};
}

} // namespace vs
