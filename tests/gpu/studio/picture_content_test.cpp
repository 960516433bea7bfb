// SPDX-License-Identifier: Apache-2.0
// Pictures of which only those pixels are cast that may have changed.
#include "base/error.h"
#include "gpu/gl_test.h"
#include "gpu/studio/any_operation.h"
#include "image/compare.h"
#include "property.h"
#include "studio/document/document_state.h"
#include "studio/document/live_growth.h"
#include "studio/state/picture_content.h"

#include <algorithm>
#include <optional>
#include <string>

namespace vs::studio {
namespace {

using PictureContentTest = test::GlTest;
using test::testHead;

constexpr glm::ivec2 kFollowed{120, 90};
// Of 255. How far rays skip depends on all cells around them, so places are the same but for the last bits.
constexpr int kMostApart = 2;

// A picture that follows a document as the window's does: where a frame may differ from what it shows.
class FollowingPicture {
public:
    // Casts what a frame of the document changes in it. Returns how many pixels that were.
    int follow(Document& document, double segmentsMs) {
        render::Frame frame = document.frame(kFollowed, segmentsMs);
        frame.samples = 4;
        frame.endsEarly = true;
        const auto voxels = shown_ ? document.changedSince(*shown_) : std::nullopt;
        shown_ = document.content();
        if (!voxels) {
            image_ = render(frame);
            return kFollowed.x * kFollowed.y;
        }
        const Box2 pixels = render::pixelsAround(*voxels, frame.rays, document.volume().geometry);
        if (pixels.isEmpty()) {
            return 0;
        }
        frame.window = pixels;
        put(render(frame), pixels);
        return pixels.size().x * pixels.size().y;
    }

    // The document's picture, cast whole. With no time for segments it shows those that the last one did.
    image::Image whole(Document& document, double segmentsMs) {
        render::Frame frame = document.frame(kFollowed, segmentsMs);
        frame.samples = 4;
        frame.endsEarly = true;
        return render(frame);
    }

    [[nodiscard]] const image::Image& image() const { return image_; }

private:
    image::Image render(const render::Frame& frame) {
        caster_.render(frame);
        return caster_.readPicture();
    }

    void put(const image::Image& part, const Box2& pixels) {
        for (int y = 0; y < part.height; ++y) {
            const auto from = part.rgba.begin() + std::ptrdiff_t(4) * y * part.width;
            std::copy_n(from, 4 * part.width,
                        image_.rgba.begin() +
                            std::ptrdiff_t(4) * ((pixels.lo.y + y) * kFollowed.x + pixels.lo.x));
        }
    }

    render::RayCaster caster_;
    std::optional<PictureContent> shown_;
    image::Image image_{kFollowed.x, kFollowed.y};
};

// And what frames are made from (macrocells, segments' surfaces), which follows changes too, is in the end as
// in a document that has seen none of them.
TEST_F(PictureContentTest, WhatIsNotCastAnewIsAsIfItWere) {
    int local = 0;
    test::checkProperty(60, [&] {
        const test::AnyOperation any([](int n) { return *test::below(n); });
        Document document(testHead());
        View view = test::testCanvas().view;
        view.mode = render::kModes[*test::below(6)];
        document.showView(view);
        FollowingPicture picture;
        FollowingPicture seldom; // as what is shown at rest is the one at rest before, with changes
        picture.follow(document, Document::kNoHurry);
        seldom.follow(document, Document::kNoHurry);
        for (int step = 0; step < 12; ++step) {
            const Operation operation = any.anything();
            try {
                document.apply(operation, std::filesystem::temp_directory_path());
            } catch (const Error&) { // it makes no sense here, and changed nothing
            }
            if (*test::below(4) == 0) {
                document.growing().prepare();
                if (*test::coin()) {
                    document.growing().giveBack();
                }
            }
            const double budgets[] = {0, 0.01, Document::kNoHurry};
            const int cast = picture.follow(document, budgets[*test::below(3)]);
            local += cast > 0 && cast < kFollowed.x * kFollowed.y ? 1 : 0;
            const auto apart = image::compare(picture.image(), picture.whole(document, 0));
            if (apart.max > kMostApart) {
                RC_LOG() << "after step " << step << ", a " << about(operation).name << ", in mode "
                         << int(document.view().mode) << " " << cast << " pixels were cast; "
                         << apart.changedFraction << " differ, by " << apart.max << " at most\n";
            }
            RC_ASSERT(apart.max <= kMostApart);
            if (*test::below(3) == 0) {
                seldom.follow(document, Document::kNoHurry);
                RC_ASSERT(image::compare(seldom.image(), seldom.whole(document, 0)).max <= kMostApart);
            }
        }
        Document anew(testHead(), document.state());
        anew.showView(document.view());
        const auto apart = image::compare(picture.whole(document, Document::kNoHurry),
                                          FollowingPicture().whole(anew, Document::kNoHurry));
        RC_ASSERT(apart.max <= kMostApart);
    });
    EXPECT_GT(local, 50) << "hardly ever was a part of the picture enough";
}

} // namespace
} // namespace vs::studio
