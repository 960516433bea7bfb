// SPDX-License-Identifier: Apache-2.0
#include "base/error.h"
#include "gpu/gl_test.h"
#include "gpu/studio/sculpture_bytes.h"
#include "gpu/studio/test_head.h"
#include "image/compare.h"
#include "studio/document/live_stroke.h"
#include "studio/json/session.h"
#include "studio/state/region.h"

#include <unistd.h>

#include <fstream>

namespace vs::studio {
namespace {

class SessionTest : public test::GlTest {
protected:
    void SetUp() override {
        GlTest::SetUp();
        folder_ = std::filesystem::temp_directory_path() / ("vs_session_" + std::to_string(getpid()));
        std::filesystem::create_directories(folder_);
        // The head as a raw file, so that the session can find it again.
        const auto head = test::testHead();
        std::ofstream(folder_ / "head.raw", std::ios::binary)
            .write(reinterpret_cast<const char*>(head.bytes.data()), std::streamsize(head.bytes.size()));
    }
    void TearDown() override {
        std::filesystem::remove_all(folder_);
        GlTest::TearDown();
    }

    Session source() const {
        Session session;
        session.volumePath = folder_ / "head.raw";
        session.rawLayout = "72x80x60:uint8:1,1,1.2";
        return session;
    }

    std::filesystem::path folder_;
};

TEST_F(SessionTest, AReplayGivesTheSameMasksLabelsAndPicture) {
    std::vector<std::string> notices;
    Document original(openVolume(source(), folder_ / "s.json", {}, notices));
    View view = test::testCanvas().view;
    original.showView(view);
    original.stroke().begin(Peel{test::ellipseAt(200, 110, 40, 30), 0, 3, false, test::testCanvas()});
    original.stroke().peelTo(9.3);
    original.stroke().commit();
    Seed seed;
    seed.strokes = {{Shape::FreeForm, {{190, 100}, {210, 120}}}};
    seed.canvas = test::testCanvas({80, 120});
    original.apply(seed);
    original.apply(Grow{12});
    original.apply(Rewind{3});
    view.mode = render::Mode::Segment;
    view.camera.azimuthDegrees = 30;
    original.showView(view);
    saveSession(folder_ / "s.json", sessionOf(original, source()));

    const Session loaded = loadSession(folder_ / "s.json");
    EXPECT_EQ(loaded.volumePath, "head.raw") << "relative, so that folder can move";
    Document replayed(openVolume(loaded, folder_ / "s.json", {}, notices));
    EXPECT_TRUE(notices.empty());
    for (const Operation& operation : loaded.operations) {
        replayed.apply(operation, folder_);
    }
    EXPECT_EQ(test::sculptureBytes(replayed), test::sculptureBytes(original));
    EXPECT_EQ(replayed.region().generations(), original.region().generations());
    EXPECT_EQ(replayed.view(), original.view());
    original.apply(SavePicture{"original.png", {300, 200}, 2}, folder_);
    replayed.apply(SavePicture{"replayed.png", {300, 200}, 2}, folder_);
    EXPECT_EQ(
        image::compare(image::readPng(folder_ / "original.png"), image::readPng(folder_ / "replayed.png"))
            .max,
        0);
}

TEST_F(SessionTest, AnotherVolumeIsRefusedUnlessAskedFor) {
    Session session = source();
    session.volumeChecksum = "0123456789abcdef";
    std::vector<std::string> notices;
    EXPECT_THROW(openVolume(session, folder_ / "s.json", {}, notices), SessionError);
    session.rawLayout.clear();
    // A replacement is read as what it is; a raw file needs its layout, so this one is a readable kind of
    // file.
    Document document(test::testHead());
    document.apply(SaveLabels{"other.nrrd"}, folder_);
    openVolume(session, folder_ / "s.json", folder_ / "other.nrrd", notices);
    ASSERT_EQ(notices.size(), 1U);
    EXPECT_NE(notices[0].find("not the volume"), std::string::npos);
}

// Beside the session, then in folders used before; never another volume of the same name.
TEST_F(SessionTest, AScanThatMovedIsFoundByNameAndChecksum) {
    std::vector<std::string> notices;
    Session session = source();
    session.volumeChecksum = volume::checksum(openVolume(session, folder_ / "s.json", {}, notices));
    session.volumePath = folder_ / "gone" / "head.raw";
    EXPECT_TRUE(notices.empty());
    openVolume(session, folder_ / "s.json", {}, notices);
    ASSERT_EQ(notices.size(), 1U);
    EXPECT_NE(notices[0].find((folder_ / "head.raw").string()), std::string::npos) << notices[0];
    // Elsewhere, behind one that has its name and nothing else.
    const auto other = folder_ / "other";
    const auto moved = folder_ / "moved";
    std::filesystem::create_directories(other);
    std::filesystem::create_directories(moved);
    std::filesystem::rename(folder_ / "head.raw", moved / "head.raw");
    std::ofstream(other / "head.raw", std::ios::binary) << std::string(std::size_t(72) * 80 * 60, '\7');
    notices.clear();
    const auto found =
        openVolume(session, folder_ / "s.json", {}, notices, {}, {other, folder_ / "none", moved});
    EXPECT_EQ(found.path, moved / "head.raw");
    Session unchecked = session; // which anything of that name might be taken for
    unchecked.volumeChecksum.clear();
    EXPECT_THROW(openVolume(unchecked, folder_ / "s.json", {}, notices, {}, {moved}), MovedVolume);
    try {
        openVolume(session, folder_ / "s.json", {}, notices, {}, {other});
        ADD_FAILURE() << "it is nowhere";
    } catch (const MovedVolume& error) {
        EXPECT_EQ(error.wanted(), session.volumePath);
        for (const char* part : {"s.json", "gone/head.raw", "--volume"}) {
            EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
        }
    }
}

TEST_F(SessionTest, AReplacementTakesFromTheSessionWhatFitsIt) {
    Session session = source();
    session.volumePath = "gone.raw";
    std::vector<std::string> notices;
    const auto open = [&](const char* file, const volume::ReadOptions& overrides = {}) {
        notices.clear();
        return openVolume(session, folder_ / "s.json", folder_ / file, notices, overrides);
    };
    EXPECT_EQ(open("head.raw").geometry.dims, glm::ivec3(72, 80, 60)) << "headerless, like the session's own";
    EXPECT_TRUE(notices.empty());
    volume::ReadOptions other;
    other.raw = volume::parseRawLayout("80x72x60:uint8");
    EXPECT_EQ(open("head.raw", other).geometry.dims, glm::ivec3(80, 72, 60));
    Document document(test::testHead());
    document.apply(SaveLabels{"other.nrrd"}, folder_);
    EXPECT_EQ(open("other.nrrd").geometry.dims, glm::ivec3(72, 80, 60)) << "by its own header";
    session.rawLayout.clear();
    session.series = "1.2.3";
    session.frame = 2;
    EXPECT_EQ(open("other.nrrd").geometry.dims, glm::ivec3(72, 80, 60));
    ASSERT_EQ(notices.size(), 1U);
    EXPECT_NE(notices[0].find("does not fit it"), std::string::npos) << notices[0];
    volume::ReadOptions used;
    openVolume(session, folder_ / "s.json", folder_ / "other.nrrd", notices, {}, {}, &used);
    EXPECT_FALSE(used.raw || used.series || used.frame) << "which is then no part of what is saved";
    other = {};
    other.frame = 1;
    EXPECT_THROW(open("other.nrrd", other), ReadError) << "asked for, so not left out";
}

TEST_F(SessionTest, WrongFilesAreNamedInOneLine) {
    const auto complaint = [&](const std::string& text) -> std::string {
        std::ofstream(folder_ / "wrong.json") << text;
        try {
            loadSession(folder_ / "wrong.json");
        } catch (const SessionError& error) {
            return error.what();
        }
        return "accepted";
    };
    const auto withVolume = [](const std::string& volume) {
        return R"({"volumeStudioSession": 1, "operations": [], "volume": )" + volume + "}";
    };
    for (const std::string& text :
         {std::string("1e999"), std::string("{"), std::string("\"\xff\""), withVolume(R"({"path": ""})"),
          withVolume(R"({"path": "a\u0000b"})"), withVolume(R"({"path": "a", "raw": "1x2"})"),
          withVolume(R"({"path": "a", "frame": 1e999})")}) {
        const std::string said = complaint(text);
        EXPECT_NE(said.find("wrong.json: "), std::string::npos) << text << ": " << said;
        EXPECT_EQ(said.find("json.exception"), std::string::npos) << said;
    }
    EXPECT_EQ(complaint(withVolume(R"({"path": "a"})")), "accepted");
}

TEST_F(SessionTest, ANameThatIsNotUtf8IsRefusedNotThrownAsJson) {
    Session session = source();
    session.volumePath = folder_ / "h\xff.raw";
    try {
        saveSession(folder_ / "s.json", session);
        FAIL();
    } catch (const WriteError& error) {
        EXPECT_NE(std::string(error.what()).find("s.json"), std::string::npos);
    }
    EXPECT_FALSE(std::filesystem::exists(folder_ / "s.json"));
}

TEST_F(SessionTest, AnUnwritablePathIsNamed) {
    try {
        saveSession(folder_ / "gone" / "s.json", source());
        FAIL();
    } catch (const WriteError& error) {
        EXPECT_NE(std::string(error.what()).find("gone"), std::string::npos);
    }
}

} // namespace
} // namespace vs::studio
