// SPDX-License-Identifier: Apache-2.0
// What becomes of a scan whose decoder crashes, hangs, is starved, stopped or killed: one line that names the
// file, and nothing that runs on.
#include "base/error.h"
#include "base/progress.h"
#include "volume/io/decode.h"
#include "volume/io/write.h"
#include "volume/reading/decoder_messages.h"
#include "volume/reading/decoder_process.h"
#include "volume/reading/read_picture.h"
#include "volume/reading/read_volume.h"
#include "volume/reading/write_segmentation.h"

#include "pretended_decoder.h"

#include <unistd.h>
#include <zlib.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <random>
#include <thread>

namespace vs::volume {
namespace {

std::string readRefusal(const std::filesystem::path& path) {
    try {
        readVolume(path);
    } catch (const ReadError& error) {
        std::string text = error.what();
        EXPECT_EQ(text.rfind(path.string() + ": ", 0), 0U) << text;
        EXPECT_EQ(text.find('\n'), std::string::npos) << text;
        return text;
    }
    ADD_FAILURE() << path << " was read";
    return {};
}

// The decoder that this process has started, if it runs.
pid_t runningDecoder() {
    std::ifstream children("/proc/self/task/" + std::to_string(getpid()) + "/children");
    for (pid_t child = 0; children >> child;) {
        std::error_code gone;
        const auto program = std::filesystem::read_symlink("/proc/" + std::to_string(child) + "/exe", gone);
        if (!gone && program.filename() == decoderProgram().filename()) {
            return child;
        }
    }
    return 0;
}

TEST(Decoder, GivesWhatDecodingHereGives) {
    const TemporaryFolder folder;
    for (const char* name : {"a.nii", "a.nii.gz", "a.nrrd", "a.mha", "a.mhd"}) {
        const auto path = cube(folder, 9, name);
        const ReadResult here = decodeVolume(path);
        const ReadResult there = readVolume(path);
        EXPECT_EQ(there.volume.bytes, here.volume.bytes) << name;
        EXPECT_EQ(there.volume.type, here.volume.type) << name;
        EXPECT_EQ(there.volume.geometry, here.volume.geometry) << name;
        EXPECT_EQ(there.volume.range.lo, here.volume.range.lo) << name;
        EXPECT_EQ(there.volume.range.hi, here.volume.range.hi) << name;
        EXPECT_EQ(there.volume.path, path);
        EXPECT_EQ(there.volume.name, here.volume.name);
        EXPECT_EQ(there.volume.details.format, here.volume.details.format);
        EXPECT_EQ(there.notices, here.notices);
    }
}

TEST(Decoder, NamesNeedNotBeText) {
    const TemporaryFolder folder;
    const auto path = cube(folder, 4, "caf\xe9 \xff.nrrd");
    EXPECT_EQ(readVolume(path).volume.geometry.dims, glm::ivec3(4));
}

TEST(Decoder, RefusesInTheSameWords) {
    const TemporaryFolder folder;
    writeFile(folder / "a.nrrd",
              "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 2 2 9\nencoding: raw\n\n12345678");
    std::string here;
    try {
        decodeVolume(folder / "a.nrrd");
    } catch (const ReadError& error) {
        here = error.what();
    }
    EXPECT_EQ(readRefusal(folder / "a.nrrd"), here);
    ReadOptions options;
    options.frame = 3;
    EXPECT_THROW(readVolume(cube(folder, 3), options), ReadError);
}

TEST(Decoder, ItsEndIsARefusal) {
    const TemporaryFolder folder;
    const auto path = cube(folder, 4);
    const std::pair<const char*, const char*> ends[] = {
        {"kill -SEGV $$", "signal 11"},
        {"kill -ABRT $$", "signal 6"},
        {"kill -KILL $$", "signal 9"},
        {"kill -PROF $$", "far more time"},
        {"kill -STOP $$", "stopped"},
        {"exit 0", "status 0"},
        {"exit 3", "status 3"},
        {"printf '\\004\\000\\000\\000abcd' >&3", "a message that is none"},
        {"printf '\\377\\377\\377\\377abcd' >&3; sleep 600", "a message of"},
        {"head -c 100000 /dev/zero >&3; exit 1", "a message that is none"},
    };
    for (const auto& [script, said] : ends) {
        const PretendedDecoder pretended(folder, script);
        EXPECT_NE(readRefusal(path).find(said), std::string::npos) << script << ": " << readRefusal(path);
        EXPECT_FALSE(hasChildren()) << script;
    }
}

TEST(Decoder, ThatIsNotThereIsNamed) {
    const TemporaryFolder folder;
    setenv("VOLUME_STUDIO_DECODER", "/nowhere/decoder", 1);
    try {
        readVolume(cube(folder, 4));
        ADD_FAILURE();
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("/nowhere/decoder"), std::string::npos) << error.what();
    }
    unsetenv("VOLUME_STUDIO_DECODER");
}

// Voxels that the answer promises and that are not there.
TEST(Decoder, VoxelsThatAreMissing) {
    const TemporaryFolder folder;
    const auto path = cube(folder, 4);
    DecodedVolume answer{decodeVolume(path)};
    const MessageBytes bytes = framed(pack(DecoderAnswer(answer)));
    writeFile(folder / "answer", std::string(bytes.begin(), bytes.end()));
    const std::string answers = "cat " + (folder / "answer").string() + " >&3; ";
    for (const char* voxels : {"", "head -c 127 /dev/zero >&3", "head -c 9 /dev/zero >&3; kill -STOP $$"}) {
        const PretendedDecoder pretended(folder, answers + voxels);
        EXPECT_NE(readRefusal(path).find("instead of 128"), std::string::npos) << voxels;
    }
    const PretendedDecoder pretended(folder, answers + "head -c 128 /dev/zero >&3");
    EXPECT_EQ(readVolume(path).volume.at({1, 1, 1}), 0);
}

TEST(Decoder, GivingUpEndsItAtOnce) {
    const TemporaryFolder folder;
    const PretendedDecoder pretended(folder, "sleep 600");
    const auto path = cube(folder, 4);
    int asked = 0;
    const ProgressListener listener([&](std::optional<double>) { return ++asked < 3; });
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_THROW(readVolume(path), GivenUp);
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(60));
    EXPECT_FALSE(hasChildren());
}

// The real one, with next to no memory or time, says so and is gone.
TEST(Decoder, Starved) {
    const TemporaryFolder folder;
    const auto path = cube(folder, 64);
    const std::string real = decoderProgram().string();
    for (const char* limit : {"ulimit -v 20000", "ulimit -n 5", "ulimit -n 3"}) {
        const PretendedDecoder pretended(folder, std::string(limit) + "\nexec " + real);
        EXPECT_FALSE(readRefusal(path).empty()) << limit;
        EXPECT_FALSE(hasChildren()) << limit;
    }
    EXPECT_EQ(readVolume(path).volume.geometry.dims, glm::ivec3(64));
}

// Killed at random while it works, as long as that takes here, or after it: the volume or a refusal, never
// half of one. One that is stopped before it is a program of its own would hold this process too, so stopping
// is left to a script (ItsEndIsARefusal). SIGSEGV is no signal for this: AddressSanitizer reports it, and
// where that interrupts the sanitizer's own allocator its report waits for itself without an end.
TEST(Decoder, KilledAtRandom) {
    const TemporaryFolder folder;
    const auto path = cube(folder, 96);
    const auto begin = std::chrono::steady_clock::now();
    const Volume whole = readVolume(path).volume;
    const auto taken = std::chrono::steady_clock::now() - begin;
    std::mt19937 random(4);
    int refused = 0;
    for (int round = 0; round < 40; ++round) {
        const int signal = round % 3 == 0 ? SIGTERM : round % 3 == 1 ? SIGABRT : SIGKILL;
        std::atomic<bool> isOver = false;
        std::thread killer([&, after = taken * (random() % 64) / 50] {
            std::this_thread::sleep_for(after);
            if (const pid_t child = runningDecoder(); !isOver && child > 0) {
                kill(child, signal);
            }
        });
        try {
            EXPECT_EQ(readVolume(path).volume.bytes, whole.bytes);
        } catch (const ReadError& error) {
            EXPECT_EQ(std::string(error.what()).rfind(path.string() + ": ", 0), 0U) << error.what();
            ++refused;
        }
        isOver = true;
        killer.join();
        EXPECT_FALSE(hasChildren());
    }
    EXPECT_GT(refused, 0);
}

std::string pictureRefusal(const std::filesystem::path& path) {
    try {
        readPicture(path);
    } catch (const ReadError& error) {
        return error.what();
    }
    return "read";
}

// A PNG that says it is 30000 x 30000 pixels wide, of which it holds none.
std::string immensePng() {
    const auto word = [](std::uint32_t value) {
        std::string bytes;
        for (int shift = 24; shift >= 0; shift -= 8) {
            bytes += char(value >> unsigned(shift));
        }
        return bytes;
    };
    const std::string header = "IHDR" + word(30000) + word(30000) + std::string("\x08\x06\0\0\0", 5);
    const auto sum = crc32(0, reinterpret_cast<const Bytef*>(header.data()), uInt(header.size()));
    return "\x89PNG\r\n\x1a\n" + word(13) + header + word(std::uint32_t(sum));
}

TEST(Decoder, ReadsPicturesThatPeopleGive) {
    const TemporaryFolder folder;
    image::Image picture(7, 5);
    for (std::size_t i = 0; i < picture.rgba.size(); ++i) {
        picture.rgba[i] = std::uint8_t(37 * i);
    }
    image::writePng(folder / "a.png", picture);
    const image::Image back = readPicture(folder / "a.png");
    EXPECT_EQ(back.width, 7);
    EXPECT_EQ(back.height, 5);
    EXPECT_EQ(back.rgba, picture.rgba);
    writeFile(folder / "bad.png", "no picture");
    EXPECT_NE(pictureRefusal(folder / "bad.png").find("bad.png: not a readable PNG"), std::string::npos);
    EXPECT_NE(pictureRefusal(folder / "gone.png").find("there is no such file"), std::string::npos);
    EXPECT_NE(pictureRefusal("/dev/zero").find("is no file"), std::string::npos);
    writeFile(folder / "immense.png", immensePng()); // 3.6 GB of pixels in 33 bytes
    EXPECT_NE(pictureRefusal(folder / "immense.png").find("immense.png: "), std::string::npos);
    const PretendedDecoder killed(folder, "kill -SEGV $$");
    EXPECT_NE(pictureRefusal(folder / "a.png").find("a.png: its decoder gave up"), std::string::npos);
}

TEST(Decoder, MakesSegmentationsAndLeavesAnOlderFileWhenItFails) {
    const TemporaryFolder folder;
    const SegmentationOrder order{makeGeometry({4, 3, 2}), {{1, "one", glm::dvec3(1)}}, {}, {}};
    const std::vector<std::uint8_t> labels(24, 1);
    EXPECT_EQ(writeDicomSegmentation(folder / "s.dcm", order, labels), 0);
    const auto size = std::filesystem::file_size(folder / "s.dcm");
    EXPECT_GT(size, 1000U);
    {
        const PretendedDecoder killed(folder, "kill -KILL $$");
        EXPECT_THROW(writeDicomSegmentation(folder / "s.dcm", order, labels), Error);
    }
    {
        // More labels than a socket holds, for one that takes none of them.
        const SegmentationOrder large{makeGeometry({256, 256, 256}), order.segments, {}, {}};
        const std::vector<std::uint8_t> many(large.geometry.voxelCount(), 1);
        const PretendedDecoder stopped(folder, "kill -STOP $$");
        EXPECT_THROW(writeDicomSegmentation(folder / "s.dcm", large, many), Error);
    }
    EXPECT_EQ(std::filesystem::file_size(folder / "s.dcm"), size);
    EXPECT_THROW(writeDicomSegmentation(folder / "gone" / "s.dcm", order, labels), WriteError);
    EXPECT_NE(readRefusal(folder / "s.dcm").find("it is a segmentation"),
              std::string::npos); // what it must be
}

} // namespace
} // namespace vs::volume
