// SPDX-License-Identifier: Apache-2.0
#include "segment/measures/measured_segment.h"

#include <fmt/format.h>

#include <cmath>

namespace vs::segment {
namespace {

// A field that holds a separator or a quote is quoted, as RFC 4180 has it.
std::string quoted(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) {
        return text;
    }
    std::string result = "\"";
    for (const char c : text) {
        result += c == '"' ? "\"\"" : std::string(1, c);
    }
    return result + '"';
}

// All digits; nothing where nothing is known.
std::string field(double value) { return std::isnan(value) ? "" : fmt::format("{:.10g}", value); }

} // namespace

std::string csvOf(const std::vector<MeasuredSegment>& segments) {
    std::string text = "label,name,colour,voxels,volume_ml,surface_mm2,finite_voxels,mean,standard_deviation,"
                       "minimum,median,maximum,box_from_i,box_from_j,box_from_k,box_to_i,box_to_j,box_to_k,"
                       "box_size_i_mm,box_size_j_mm,box_size_k_mm,"
                       "centroid_left_mm,centroid_posterior_mm,centroid_superior_mm\n";
    for (const MeasuredSegment& segment : segments) {
        const auto& s = segment.statistics;
        const auto& values = s.intensities;
        const auto last = s.box.hi - 1;
        text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n",
                            segment.label, quoted(segment.name),
                            segment.colour ? fmt::format("#{:02X}{:02X}{:02X}", segment.colour->r,
                                                         segment.colour->g, segment.colour->b)
                                           : "",
                            s.voxels, field(s.millilitres), field(s.surfaceMm2), values.voxels,
                            field(values.mean), field(values.deviation), field(values.smallest),
                            field(values.median), field(values.largest), s.box.lo.x, s.box.lo.y, s.box.lo.z,
                            last.x, last.y, last.z, field(s.boxMm.x), field(s.boxMm.y), field(s.boxMm.z),
                            field(s.centroid.x), field(s.centroid.y), field(s.centroid.z));
    }
    return text;
}

} // namespace vs::segment
