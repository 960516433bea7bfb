// SPDX-License-Identifier: Apache-2.0
#include "segment/measures/shape.h"

#include <glm/gtc/constants.hpp>
#include <itkSymmetricEigenAnalysis.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vs::segment {
namespace {

glm::dvec3 turnedPositive(glm::dvec3 direction) {
    const glm::dvec3 size = glm::abs(direction);
    const int most = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    return direction[most] < 0 ? -direction : direction;
}

} // namespace

std::array<PrincipalAxis, 3> principalAxes(const glm::dmat3& covarianceMm2) {
    using Matrix = itk::Matrix<double, 3, 3>;
    Matrix matrix;
    for (unsigned row = 0; row < 3; ++row) {
        for (unsigned column = 0; column < 3; ++column) {
            matrix(row, column) = covarianceMm2[int(column)][int(row)];
        }
    }
    itk::SymmetricEigenAnalysisFixedDimension<3, Matrix, itk::Vector<double, 3>> analysis;
    itk::Vector<double, 3> values; // ascending
    Matrix vectors;                // one a row
    analysis.ComputeEigenValuesAndVectors(matrix, values, vectors);
    std::array<PrincipalAxis, 3> axes;
    for (unsigned i = 0; i < 3; ++i) {
        const unsigned from = 2 - i;
        axes[i].direction = turnedPositive({vectors(from, 0), vectors(from, 1), vectors(from, 2)});
        axes[i].lengthMm = 2 * std::sqrt(5 * std::max(values[from], 0.0));
    }
    return axes;
}

double sphericity(double millilitres, double surfaceMm2) {
    if (surfaceMm2 <= 0) {
        return std::numeric_limits<double>::quiet_NaN();
    }
    const double mm3 = 1000 * millilitres;
    return std::cbrt(glm::pi<double>() * 36 * mm3 * mm3) / surfaceMm2;
}

} // namespace vs::segment
