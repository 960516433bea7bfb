// SPDX-License-Identifier: Apache-2.0
// How slices lie in their pictures: conventions, letters, distances, on straight, flipped, oblique and
// sheared grids.
#include "render/slices/slice_view.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace vs::render {
namespace {

volume::GridGeometry gridOf(glm::dvec3 x, glm::dvec3 y, glm::dvec3 z, glm::dvec3 origin = {10, -20, 30}) {
    volume::GridGeometry grid;
    grid.dims = {40, 50, 60};
    grid.worldFromVoxel =
        glm::dmat4(glm::dvec4(x, 0), glm::dvec4(y, 0), glm::dvec4(z, 0), glm::dvec4(origin, 1));
    return grid;
}

std::string lettersOf(const volume::GridGeometry& grid, SliceKind kind) {
    const auto letters = SliceGeometry(grid, kind).letters();
    return letters.left + "|" + letters.right + "|" + letters.top + "|" + letters.bottom;
}

std::vector<volume::GridGeometry> variousGrids() {
    const glm::dmat3 turn(glm::rotate(glm::dmat4(1), 0.5, glm::dvec3(0.3, 1, -0.4)));
    return {gridOf({1, 0, 0}, {0, 1, 0}, {0, 0, 1}),             // LPS, as DICOM
            gridOf({-0.9, 0, 0}, {0, -1.1, 0}, {0, 0, 2}),       // RAS, as NIfTI
            gridOf({0, 1.5, 0}, {0, 0, -0.7}, {-2.5, 0, 0}),     // sagittal slices, stored from left to right
            gridOf(turn[0] * 0.8, turn[1] * 1.2, turn[2] * 3.0), // oblique
            gridOf({1, 0, 0}, {0.2, 1, 0}, {0, 0.4, 2})};        // sheared: a tilted gantry
}

TEST(SliceView, PicturesFollowTheRadiologistsConvention) {
    for (const auto& grid : variousGrids()) {
        const bool isOblique = grid == variousGrids()[3] || grid == variousGrids()[4];
        if (!isOblique) {
            EXPECT_EQ(lettersOf(grid, SliceKind::Axial), "R|L|A|P");
            EXPECT_EQ(lettersOf(grid, SliceKind::Coronal), "R|L|S|I");
            EXPECT_EQ(lettersOf(grid, SliceKind::Sagittal), "A|P|S|I");
        } else {
            EXPECT_EQ(lettersOf(grid, SliceKind::Axial)[0], 'R');
            EXPECT_EQ(SliceGeometry(grid, SliceKind::Sagittal).letters().top[0], 'S');
        }
    }
}

// Turned by 30 degrees about the patient's long axis: what was left is now left and, less, posterior.
TEST(SliceView, LettersOfObliqueGridsNameWhatTheyLeanTo) {
    const glm::dmat3 turn(glm::rotate(glm::dmat4(1), glm::radians(30.0), glm::dvec3(0, 0, 1)));
    const auto grid = gridOf(turn[0], turn[1], turn[2]);
    EXPECT_EQ(lettersOf(grid, SliceKind::Axial), "RA|LP|AL|PR");
    EXPECT_EQ(lettersOf(grid, SliceKind::Coronal), "RA|LP|S|I");
    const glm::dmat3 little(glm::rotate(glm::dmat4(1), glm::radians(10.0), glm::dvec3(0, 0, 1)));
    EXPECT_EQ(lettersOf(gridOf(little[0], little[1], little[2]), SliceKind::Axial), "R|L|A|P");
}

TEST(SliceView, EachKindHasAnAxisOfItsOwn) {
    for (const auto& grid : variousGrids()) {
        int sum = 0;
        for (const SliceKind kind : kSliceKinds) {
            const SliceGeometry geometry(grid, kind);
            sum += 1 << geometry.axis();
            EXPECT_EQ((1 << geometry.axis()) + (1 << geometry.acrossAxis()) + (1 << geometry.downAxis()), 7);
            EXPECT_EQ(geometry.count(), grid.dims[geometry.axis()]);
        }
        EXPECT_EQ(sum, 7);
    }
}

TEST(SliceView, PlacesAreTrueToScaleAndComeBack) {
    for (const auto& grid : variousGrids()) {
        for (const SliceKind kind : kSliceKinds) {
            const SliceGeometry geometry(grid, kind);
            EXPECT_NEAR(glm::dot(geometry.right(), geometry.down()), 0, 1e-12);
            glm::dvec3 a{3, 41, 17.25};
            glm::dvec3 b{31.5, 7, 52};
            b[geometry.axis()] = a[geometry.axis()] = 11;
            for (const glm::dvec3 voxel : {a, b}) {
                const glm::dvec3 back = geometry.voxelAt(geometry.placeOf(voxel), 11);
                EXPECT_LT(glm::length(back - voxel), 1e-9);
            }
            const glm::dvec3 apart(grid.worldFromVoxel * glm::dvec4(b - a, 0.0));
            EXPECT_NEAR(glm::length(geometry.placeOf(b) - geometry.placeOf(a)), glm::length(apart), 1e-9);
            EXPECT_NEAR(glm::dot(apart, geometry.normal()), 0, 1e-9);
        }
    }
}

TEST(SliceView, PositionsAreTheWorldsAndRiseOnwards) {
    const SliceGeometry axial(gridOf({-0.9, 0, 0}, {0, -1.1, 0}, {0, 0, 2}), SliceKind::Axial);
    EXPECT_EQ(axial.onwards(), 1);
    EXPECT_NEAR(axial.positionMm(7), 30 + 14, 1e-12);
    for (const auto& grid : variousGrids()) {
        for (const SliceKind kind : kSliceKinds) {
            const SliceGeometry geometry(grid, kind);
            EXPECT_GT(geometry.positionMm(5 + geometry.onwards()), geometry.positionMm(5));
        }
    }
}

TEST(SliceView, AllOfASliceFitsIntoItsPicture) {
    for (const auto& grid : variousGrids()) {
        for (const SliceKind kind : kSliceKinds) {
            const SliceGeometry geometry(grid, kind);
            const glm::ivec2 size{320, 200};
            const SliceView view{kind, 0, {0, 0}, pixelMmToShowAll(geometry, size), size};
            for (int corner = 0; corner < 8; ++corner) {
                const glm::dvec3 part(corner & 1, (corner >> 1) & 1, corner >> 2);
                const glm::dvec2 pixel = view.pixelOf(geometry.placeOf(part * glm::dvec3(grid.dims) - 0.5));
                EXPECT_TRUE(glm::all(glm::greaterThan(pixel, glm::dvec2(0))));
                EXPECT_TRUE(glm::all(glm::lessThan(pixel, glm::dvec2(size))));
            }
            EXPECT_LT(glm::length(view.placeAt(view.pixelOf({3, -4})) - glm::dvec2(3, -4)), 1e-9);
        }
    }
}

} // namespace
} // namespace vs::render
