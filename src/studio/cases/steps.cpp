// SPDX-License-Identifier: Apache-2.0
#include "studio/cases/steps.h"

namespace vs::studio {

std::vector<Step> stepsOf(std::span<const Operation> operations) {
    std::vector<Step> steps;
    for (std::size_t i = 0; i < operations.size(); ++i) {
        const auto* note = std::get_if<Note>(&operations[i]);
        if (note != nullptr || steps.empty()) {
            steps.push_back({note != nullptr ? note->text : std::string(), i, 0});
        }
        ++steps.back().count;
    }
    return steps;
}

} // namespace vs::studio
