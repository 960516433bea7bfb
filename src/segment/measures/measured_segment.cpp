// SPDX-License-Identifier: Apache-2.0
#include "segment/measures/measured_segment.h"

#include "base/csv.h"

#include <fmt/format.h>

#include <cmath>

namespace vs::segment {
namespace {

// All digits; nothing where nothing is known.
std::string field(double value) { return std::isnan(value) ? "" : fmt::format("{:.10g}", value); }

// Behind a separator each.
std::string fieldsOf(glm::dvec3 values) {
    return fmt::format(",{},{},{}", field(values.x), field(values.y), field(values.z));
}

std::string lineOf(const MeasuredSegment& segment) {
    const auto& s = segment.statistics;
    const auto& values = s.intensities;
    const auto last = s.box.hi - 1;
    const std::string colour = segment.colour ? fmt::format("#{:02X}{:02X}{:02X}", segment.colour->r,
                                                            segment.colour->g, segment.colour->b)
                                              : "";
    std::string text = fmt::format("{},{},{},{},{},{}", segment.label, csvField(segment.name), colour,
                                   s.voxels, field(s.millilitres), field(s.surfaceMm2));
    text += fmt::format(",{},{},{},{},{},{}", values.voxels, field(values.mean), field(values.deviation),
                        field(values.smallest), field(values.median), field(values.largest));
    text += fmt::format(",{},{},{},{},{},{}", s.box.lo.x, s.box.lo.y, s.box.lo.z, last.x, last.y, last.z);
    text += fieldsOf(s.boxMm) + fieldsOf(s.centroid);
    text += fmt::format(",{},{},{},{},{}", field(s.sphericity), s.topology.parts, s.topology.tunnels(),
                        s.topology.cavities, s.topology.euler);
    for (const PrincipalAxis& axis : s.axes) {
        text += fmt::format(",{}", field(axis.lengthMm)) + fieldsOf(axis.direction);
    }
    return text + '\n';
}

} // namespace

std::string csvOf(const std::vector<MeasuredSegment>& segments) {
    std::string text = "label,name,colour,voxels,volume_ml,surface_mm2,finite_voxels,mean,standard_deviation,"
                       "minimum,median,maximum,box_from_i,box_from_j,box_from_k,box_to_i,box_to_j,box_to_k,"
                       "box_size_i_mm,box_size_j_mm,box_size_k_mm,"
                       "centroid_left_mm,centroid_posterior_mm,centroid_superior_mm,"
                       "sphericity,parts,tunnels,cavities,euler_number";
    for (int axis = 1; axis <= 3; ++axis) {
        text += fmt::format(",axis_{0}_mm,axis_{0}_left,axis_{0}_posterior,axis_{0}_superior", axis);
    }
    text += '\n';
    for (const MeasuredSegment& segment : segments) {
        text += lineOf(segment);
    }
    return text;
}

} // namespace vs::segment
