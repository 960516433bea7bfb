// SPDX-License-Identifier: Apache-2.0
// A segment that is pulled out looks as it would alone under a moved camera, follows all that becomes of it
// in the next picture, and takes no memory of its own.
#include "gpu/gl_test.h"
#include "gpu/studio/test_segments.h"
#include "image/compare.h"
#include "render/rays/ray_caster.h"
#include "segment/membership/segmentation.h"

#include <algorithm>
#include <cmath>

namespace vs::studio {
namespace {

using PullOutTest = test::GlTest;

constexpr glm::ivec2 kPicture{260, 200};
constexpr int kDims = 56;
const glm::dvec3 kCentre(0.5 * (kDims - 1));

// Three segments: a ball, the shell around it, and a slab that touches both.
constexpr std::array<const char*, 3> kNames{"ball", "shell", "slab"};
int partAt(glm::dvec3 p) {
    const double r = glm::length(p - kCentre);
    const bool isSlab = p.x - kCentre.x + 0.4 * (p.y - kCentre.y) > 7.3;
    return r < 19.6 && isSlab ? 3 : r < 11.4 ? 1 : r < 19.6 ? 2 : 0;
}

volume::Volume scan() {
    return phantom::makePhantom(glm::ivec3(kDims), volume::ScalarType::UInt8, [](glm::dvec3 p) {
        return partAt(p) == 0 ? 0.0 : 60.0 + 40 * partAt(p) + p.z;
    });
}

std::shared_ptr<const volume::LabelMap> labels(const volume::Volume& volume) {
    auto map = std::make_shared<volume::LabelMap>();
    map->geometry = volume.geometry;
    map->values = {0, 1, 2, 3};
    for (int z = 0; z < kDims; ++z) {
        for (int y = 0; y < kDims; ++y) {
            for (int x = 0; x < kDims; ++x) {
                map->labels.push_back(std::uint8_t(partAt(glm::dvec3(x, y, z))));
            }
        }
    }
    for (int n = 0; n < 3; ++n) {
        map->looks[n + 1] = {kNames[std::size_t(n)], {}};
    }
    return map;
}

View lookAt(render::Mode mode) {
    View view;
    view.mode = mode;
    view.range = {30, 255};
    view.camera = {30, 20, 1.1, {}, render::Projection::Perspective};
    return view;
}

render::Placement aside() {
    render::Placement place;
    place.moveMm = {9, -6, 4};
    place.turnDegrees = {20, -35, 50};
    place.scale = 1.2;
    return place;
}

struct Parts {
    Document document{scan()};

    explicit Parts(render::Mode mode = render::Mode::Segment) {
        LoadLabels load;
        load.path = "labels.nrrd";
        load.map = labels(document.volume());
        document.apply(load);
        document.showView(lookAt(mode));
    }
    void look(const std::string& name, double opacity) {
        UseSegment use{name};
        use.opacity = opacity;
        use.goesToWork = false;
        document.apply(use);
    }
    static image::Image cast(const render::Frame& frame) {
        render::RayCaster caster;
        caster.render(frame);
        return caster.readPicture();
    }
    // The whole picture.
    image::Image picture() { return cast(document.frame(kPicture)); }
    // What is pulled out, without what remains in its place.
    image::Image pulledOut() {
        render::Frame frame = document.frame(kPicture);
        frame.scene.sculpture = nullptr;
        frame.scene.view = field::SculptureView::Probe; // of nothing
        return cast(frame);
    }
    // The segment alone in its place, as a camera sees it that moves as if the segment had.
    image::Image alone(const std::string& name, const render::Placement& place) {
        document.apply(ShowSegments{name});
        View view = document.view();
        const bool isData = view.mode == render::Mode::Mip || view.mode == render::Mode::XRay;
        view.range = isData ? view.range : Range{300, 301}; // of the data nothing
        view.mode = view.mode == render::Mode::Surface ? render::Mode::Segment : view.mode;
        document.showView(view);
        document.apply(PutBack{name});
        render::Frame frame = document.frame(kPicture);
        frame.rays = render::seenFromPart(frame.rays, place, document.volume().geometry);
        return cast(frame);
    }
};

// It has the same bytes as alone. They lie in another texture, so that what is between voxels may come out
// otherwise in the last bits of a float, and a pixel by a level.
constexpr double kRounding = 0.002;  // of 255, on average
constexpr double kOneSideCut = 0.02; // where a cut's face takes the place of the segment's own
void expectAlike(const image::Image& a, const image::Image& b, double most, const std::string& what) {
    const auto difference = image::compare(a, b);
    fmt::print("{}: mean {:.4f}, of {:.4f} %\n", what, difference.mean, 100 * difference.changedFraction);
    EXPECT_LT(difference.mean, most) << what;
    EXPECT_LT(difference.changedFraction, most / 20) << what;
}

double coveredBy(const image::Image& seen) {
    Document nothing(
        phantom::makePhantom(glm::ivec3(8), volume::ScalarType::UInt8, [](glm::dvec3) { return 0.0; }));
    nothing.showView(lookAt(render::Mode::Segment));
    return image::compare(seen, Parts::cast(nothing.frame(kPicture))).changedFraction;
}

TEST_F(PullOutTest, LooksAsTheSegmentDoesAloneUnderTheMovedCamera) {
    for (const auto mode :
         {render::Mode::Segment, render::Mode::Overlay, render::Mode::Surface, render::Mode::Volume}) {
        for (const std::string name : kNames) {
            for (const double opacity : {1.0, 0.4}) {
                if (mode == render::Mode::Surface && opacity < 1) {
                    continue; // has no glass
                }
                Parts parts(mode);
                parts.look(name, opacity);
                parts.document.apply(PullOut{name, aside()});
                const auto seen = parts.pulledOut();
                EXPECT_GT(coveredBy(seen), 0.05);
                expectAlike(seen, parts.alone(name, aside()), kRounding,
                            fmt::format("mode {} {} {}", int(mode), name, opacity));
            }
        }
    }
}

// With no other segment there is nothing to take apart.
TEST_F(PullOutTest, IsTheSameToTheByteWhereNoOtherTouchesIt) {
    for (const auto mode : {render::Mode::Segment, render::Mode::Overlay}) {
        Parts parts(mode);
        parts.document.apply(RemoveSegment{"shell"});
        parts.document.apply(RemoveSegment{"slab"});
        parts.document.apply(PullOut{"ball", aside()});
        const auto seen = parts.pulledOut();
        EXPECT_EQ(seen.rgba, parts.alone("ball", aside()).rgba);
    }
}

// A tool that spares it cuts along its surface, which is no section of it.
TEST_F(PullOutTest, KeepsItsColourWhereTheScanBesideItWasCut) {
    for (const auto mode : {render::Mode::Segment, render::Mode::Overlay}) {
        Parts parts(mode);
        parts.document.apply(RemoveSegment{"shell"});
        parts.document.apply(RemoveSegment{"slab"});
        UseSegment spare{"ball"};
        spare.treatment = SegmentInfo::Treatment::Spare;
        parts.document.apply(spare);
        parts.document.apply(PullOut{"ball", aside()});
        const auto before = parts.pulledOut();
        Clip half;
        half.box = Clip::Box{{-1, -1, 0.5 * kDims}, {kDims, kDims, kDims}};
        half.cutsInside = true;
        EXPECT_GT(parts.document.apply(half).voxelsTouched, 0U);
        // The cut's surface and the segment's agree to a fraction of a voxel.
        expectAlike(before, parts.pulledOut(), kOneSideCut, fmt::format("mode {}", int(mode)));
    }
}

// In MIP and X-ray it is the data in the segment: what would be left if all else had been cut away.
TEST_F(PullOutTest, IsTheDataInItWhereRaysGoThrough) {
    render::Placement place = aside();
    place.scale = 1; // or rays would go through more of it than a camera sees them do
    for (const auto mode : {render::Mode::Mip, render::Mode::XRay}) {
        Parts parts(mode);
        parts.document.apply(PullOut{"shell", place});
        const auto seen = parts.pulledOut();
        EXPECT_GT(coveredBy(seen), 0.05);
        parts.document.apply(UseSegment{"shell"});
        parts.document.apply(CutSegment{true, 0});
        expectAlike(seen, parts.alone("shell", place), kOneSideCut, fmt::format("mode {}", int(mode)));
    }
}

TEST_F(PullOutTest, FollowsAllThatBecomesOfTheSegmentInTheNextPicture) {
    Parts parts;
    Document& document = parts.document;
    document.apply(UseSegment{"grown"});
    Seed seed;
    seed.voxels = {{kDims / 2, kDims / 2, 2}};
    seed.range = Range{0, 10}; // the air around the parts, which it touches
    document.apply(seed);
    document.apply(PullOut{"grown", aside()});
    Clip clip;
    clip.planes = {{kCentre, {0, 0.3, 1}}};
    UseSegment repaint{"grown"};
    repaint.colour = glm::dvec3(0.2, 0.9, 0.4);
    const std::vector<Operation> steps{Grow{9},
                                       Rewind{4},
                                       ShowGeneration{3},
                                       Grow{14},
                                       Undo{},
                                       Redo{},
                                       repaint,
                                       clip,
                                       test::editOf(EditSegment::Kind::Unite, 0, "slab"),
                                       Undo{},
                                       UnCut{},
                                       test::editOf(EditSegment::Kind::Subtract, 3, "shell"),
                                       PullOut{"grown", render::Placement{{-12, 3, 0}, {0, 0, 30}, 0.8}}};
    for (const Operation& step : steps) {
        document.apply(step);
        const auto seen = parts.pulledOut();
        Parts fresh;
        for (std::size_t n = 1; n < document.log().size(); ++n) {
            fresh.document.apply(document.log()[n]);
        }
        const auto place = document.segments().find("grown")->pulledOut->place;
        expectAlike(seen, fresh.alone("grown", place), kRounding, about(step).name);
    }
}

// Two regions that grew up to the same cut go on behind it, each for itself.
TEST_F(PullOutTest, HasNothingOfAnotherBehindACut) {
    for (const bool isSmooth : {true, false}) {
        Parts parts;
        Document& document = parts.document;
        for (const std::string name : kNames) {
            document.apply(RemoveSegment{name});
        }
        Clip clip;
        clip.planes = {{kCentre, {0.2, 0.3, 1}}};
        document.apply(clip);
        // The ball and the shell, by their values.
        const std::array<Range, 2> ranges{Range{100, 139}, Range{140, 176}};
        document.apply(test::seedAt({kDims / 2, kDims / 2, 20}, ranges[0]));
        document.apply(Grow{});
        UseSegment next{"second"};
        document.apply(next);
        Seed seed = test::seedAt({kDims / 2 - 15, kDims / 2, 20}, ranges[1]);
        document.apply(seed);
        document.apply(Grow{});
        View view = document.view();
        view.smoothsSegments = isSmooth;
        document.showView(view);
        document.apply(PullOut{"second", aside()});
        const auto seen = parts.pulledOut();
        EXPECT_GT(coveredBy(seen), 0.05);
        expectAlike(seen, parts.alone("second", aside()), kRounding, fmt::format("smooth {}", isSmooth));
    }
}

// Drawn voxel by voxel it is what it is alone, too, and smooth again it is what it was.
TEST_F(PullOutTest, IsDrawnVoxelByVoxelWhereTheViewSaysSo) {
    Parts parts;
    parts.document.apply(PullOut{"shell", aside()});
    const auto smooth = parts.picture();
    SetView voxels;
    voxels.smoothsSegments = false;
    parts.document.apply(voxels);
    const auto values = parts.document.frame(kPicture).scene.segmentation->downloadAll<std::uint8_t>();
    EXPECT_TRUE(
        std::all_of(values.begin(), values.end(), [](int value) { return value == 0 || value == 255; }));
    const auto rough = parts.picture();
    EXPECT_NE(rough.rgba, smooth.rgba);
    const auto seen = parts.pulledOut();
    voxels.smoothsSegments = true;
    parts.document.apply(voxels);
    EXPECT_EQ(parts.picture().rgba, smooth.rgba);
    voxels.smoothsSegments = false;
    parts.document.apply(voxels);
    expectAlike(seen, parts.alone("shell", aside()), kRounding, "voxels");
}

// A voxel that goes from one segment to another leaves all of them together as they were.
TEST_F(PullOutTest, LosesWhatAnotherSegmentTakes) {
    Parts parts;
    parts.document.apply(PullOut{"shell", aside()});
    const auto before = parts.pulledOut();
    parts.document.apply(UseSegment{"ball"});
    parts.document.apply(test::editOf(EditSegment::Kind::Unite, 0, "shell"));
    EXPECT_EQ(coveredBy(parts.pulledOut()), 0) << "it is empty now";
    parts.document.apply(Undo{});
    expectAlike(parts.pulledOut(), before, kRounding, "back again");
}

TEST_F(PullOutTest, StaysInItsPlaceTooAndGoesBack) {
    Parts parts;
    const auto without = parts.picture();
    render::Placement far;
    far.moveMm = {500, 0, 0}; // out of the picture
    parts.document.apply(PullOut{"shell", far});
    EXPECT_EQ(parts.picture().rgba, without.rgba);
    parts.document.apply(PullOut{"shell", aside()});
    const auto with = parts.picture();
    EXPECT_NE(with.rgba, without.rgba);
    parts.document.apply(PutBack{"shell"});
    EXPECT_EQ(parts.picture().rgba, without.rgba);
    parts.document.apply(Undo{});
    EXPECT_EQ(parts.picture().rgba, with.rgba);
    UseSegment hide{"shell"};
    hide.isVisible = false;
    parts.document.apply(hide);
    EXPECT_EQ(coveredBy(parts.pulledOut()), 0) << "hidden in both places";
}

TEST_F(PullOutTest, RefusesWhatIsNotThere) {
    Parts parts;
    const auto before = test::stateOf(parts.document);
    EXPECT_THROW(parts.document.apply(PullOut{"liver", {}}), Error);
    EXPECT_THROW(parts.document.apply(PutBack{"liver"}), Error);
    EXPECT_THROW(parts.document.apply(PutBack{"ball"}), Error);
    EXPECT_TRUE(test::stateOf(parts.document) == before);
}

std::size_t bytesWith(const Document& document, const std::vector<std::uint8_t>& apart) {
    segment::Segmentation segmentation(document.volume().geometry);
    segmentation.keepApart(apart);
    segmentation.update(*document.region().growth());
    return segmentation.deviceBytes();
}

// A segment that no other touches costs a page for each tile, and a bit a voxel that all share.
TEST_F(PullOutTest, TakesNoMoreThanATableWhereNoOtherTouchesIt) {
    constexpr int dims = 128;
    Document document(
        phantom::makePhantom(glm::ivec3(dims), volume::ScalarType::UInt8, [](glm::dvec3) { return 100.0; }));
    for (const int x : {24, 100}) {
        document.apply(UseSegment{"at " + std::to_string(x)});
        Seed seed;
        seed.voxels = {{x, 64, 64}};
        seed.range = Range{0, 255};
        document.apply(seed);
        document.apply(Grow{16});
    }
    const double tiles = 8 * 8 * 8;
    const double bricks = (4 * 4 * 4 + 1) * 4096; // of a bit a voxel, with one of zeros
    const double list = tiles * 32; // of the labels that reach each tile, while it is brought up to date
    const double none = double(bytesWith(document, {}));
    const double one = double(bytesWith(document, {1}));
    EXPECT_LE(one - none, 4 * tiles + bricks + list);
    EXPECT_LE(double(bytesWith(document, {1, 2})) - one, 4 * tiles);
}

// Beside others it also takes about a byte for each voxel of the tiles that they share.
TEST_F(PullOutTest, TakesTheTilesThatItSharesWithOthers) {
    Parts parts;
    const double tiles = 4 * 4 * 4;
    const double bricks = 9 * 4096;
    const double most = 4 * 17 * 17 * 17 * tiles; // tiles are taken by layers
    const double none = double(bytesWith(parts.document, {}));
    const double one = double(bytesWith(parts.document, {1}));
    EXPECT_GT(one, none);
    EXPECT_LE(one - none, 4 * tiles + bricks + 32 * tiles + most);
}

} // namespace
} // namespace vs::studio
