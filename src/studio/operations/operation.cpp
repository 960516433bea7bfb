// SPDX-License-Identifier: Apache-2.0
#include "studio/operations/operation.h"

#include <utility>

namespace vs::studio {

namespace {

template <std::size_t... I>
std::vector<const char*> namesOfAll(std::index_sequence<I...>) {
    return {std::variant_alternative_t<I, Operation>::kAbout.name...};
}

} // namespace

const About& about(const Operation& operation) {
    return std::visit([](const auto& op) -> const About& { return op.kAbout; }, operation);
}

std::vector<const char*> operationNames() {
    return namesOfAll(std::make_index_sequence<std::variant_size_v<Operation>>());
}

const char* name(const Operation& operation) { return about(operation).name; }

std::vector<Phrase> details(const Operation& operation) {
    return std::visit(
        [](const auto& op) {
            if constexpr (requires { op.details(); }) {
                return op.details();
            } else {
                return std::vector<Phrase>();
            }
        },
        operation);
}

bool cuts(const Operation& operation) { return about(operation).effect == Effect::Cuts; }

bool isEdit(const Operation& operation) {
    return !isOutput(operation) && about(operation).effect != Effect::ChangesView;
}

bool isOutput(const Operation& operation) { return about(operation).effect == Effect::Writes; }

} // namespace vs::studio
