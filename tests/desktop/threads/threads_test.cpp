// SPDX-License-Identifier: Apache-2.0
// What moves between threads in the window's model: long work, volumes and label maps that are read, segments
// that are measured. Small, without widgets, so that ThreadSanitizer can watch it (doc/contributing.md).
#include "engine/long_work.h"
#include "model/segments/segment_controller.h"
#include "model/segments/segment_measurer.h"
#include "model/studio/studio_controller.h"
#include "phantom/phantom.h"
#include "seen_events.h"
#include "volume/io/write.h"

#include "base/progress.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QElapsedTimer>

#include <dlfcn.h>
#include <filesystem>
#include <functional>
#include <iostream>
#include <link.h>
#include <string>
#include <thread>
#include <vector>

namespace vs::desktop {
namespace {

constexpr glm::ivec3 kSize{24, 20, 16};
std::filesystem::path folder; // of files that tests write

void waitFor(const std::function<bool()>& condition) {
    constexpr int kLongMs = 60000;
    QElapsedTimer since;
    since.start();
    while (!condition() && since.elapsed() < kLongMs) {
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents, 20);
    }
    ASSERT_TRUE(condition()) << "waited " << kLongMs << " ms";
}

class ThreadsTest : public testing::Test {
protected:
    void SetUp() override {
        volume::writeVolume(path, phantom::makeBall(kSize, {12, 10, 8}, 6));
        OpenRequest request;
        request.volume = path;
        studio.files().open(request);
        waitFor([this] { return studio.host().document() != nullptr && !studio.host().isLoading(); });
    }
    void TearDown() override { studio.files().close(); }

    std::filesystem::path path = folder / "ball.nrrd";
    StudioController studio;
};

TEST_F(ThreadsTest, AVolumeThatWasReadBesideTheWindowIsHere) {
    ASSERT_NE(studio.host().volume(), nullptr);
    EXPECT_EQ(studio.host().geometry()->dims, kSize);
}

TEST_F(ThreadsTest, ReadingCanBeGivenUp) {
    bool isOver = false;
    for (const auto signal : {&DocumentHost::opened, &DocumentHost::givenUp}) {
        QObject::connect(&studio.host(), signal, &studio, [&isOver] { isOver = true; });
    }
    studio.files().open(studio.files().source());
    studio.host().giveUp();
    waitFor([&] { return isOver && !studio.host().isLoading(); });
}

TEST_F(ThreadsTest, LongWorkReadsAndWritesWhatTheCallerHas) {
    std::vector<int> numbers{1, 2, 3};
    std::thread::id worker;
    studio.host().runLong([&] {
        worker = std::this_thread::get_id();
        for (int& number : numbers) {
            number *= 2;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(120)); // the window answers meanwhile
        numbers.push_back(int(studio.host().gl().errorCount()));
    });
    EXPECT_NE(worker, std::this_thread::get_id());
    EXPECT_EQ(numbers, (std::vector<int>{2, 4, 6, 0}));
}

TEST_F(ThreadsTest, LongWorkTellsHowFarItIsUntilItIsGivenUp) {
    int seen = -1;
    LongWork work(studio.host().gl());
    QObject::connect(&work, &LongWork::lasts, &work, [&](int thousandths) {
        seen = std::max(seen, thousandths);
        work.giveUp();
    });
    const auto endless = [] {
        while (true) {
            reportProgress(0.25);
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    };
    EXPECT_THROW(work.run(endless, LongWork::Input::GivesUp), GivenUp);
    EXPECT_GE(seen, 250);
}

TEST_F(ThreadsTest, LabelsAreReadAndMeasuredBesideTheWindow) {
    const auto labels = phantom::makePhantom(kSize, volume::ScalarType::UInt8,
                                             [](glm::dvec3 voxel) { return voxel.z < 4 ? 1.0 : 0.0; });
    const auto labelPath = folder / "labels.nrrd";
    volume::writeVolume(labelPath, labels);
    const QObject somebody;
    studio.measurer().want(&somebody, true);
    studio.segments().openLabels(labelPath);
    waitFor([this] { return !studio.measurer().isMeasuring() && !studio.measurer().segments().empty(); });
    ASSERT_EQ(studio.measurer().segments().size(), 1U);
    EXPECT_EQ(studio.measurer().segments().front().statistics.voxels, std::size_t(kSize.x * kSize.y * 4));
    studio.measurer().want(&somebody, false);
}

// ThreadSanitizer ends a program that unloads a library which its suppressions name, as Qt does with the
// driver's at the very end.
void keepLibraries() {
    std::vector<std::string> names;
    dl_iterate_phdr(
        [](dl_phdr_info* library, std::size_t, void* known) {
            static_cast<std::vector<std::string>*>(known)->emplace_back(library->dlpi_name);
            return 0;
        },
        &names);
    for (const std::string& name : names) {
        dlopen(name.c_str(), RTLD_NOW | RTLD_NOLOAD | RTLD_NODELETE);
    }
}

} // namespace
} // namespace vs::desktop

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    if (argc != 2) {
        std::cerr << "usage: vs_thread_tests FOLDER\n";
        return 2;
    }
    vs::desktop::SeenApplication application(argc, argv);
    QApplication::setApplicationName("volume-studio");
    vs::desktop::folder = argv[1];
    const int result = RUN_ALL_TESTS();
    vs::desktop::keepLibraries();
    return result;
}
