// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "growing_measure.h"

#include <nlohmann/json.hpp>

namespace vs {

// What was measured, as tables in Markdown on standard output, row by row as they come, and as JSON with
// every single time.
class GrowingReport {
public:
    explicit GrowingReport(const std::string& device);

    void add(const std::string& part, const Comparison& comparison);
    void add(const ChangeCost& change);
    void add(const ScrubCost& scrub);
    [[nodiscard]] std::string json() const { return json_.dump(2) + "\n"; }

private:
    void begin(const std::string& table, const std::string& header);

    nlohmann::ordered_json json_;
    std::string table_; // the one that rows go to
};

} // namespace vs
