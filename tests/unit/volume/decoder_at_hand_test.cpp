// SPDX-License-Identifier: Apache-2.0
// A decoder that waits is used by the next reading, whatever became of it meanwhile nobody is told, and
// nothing is left of it.
#include "base/error.h"
#include "volume/reading/decoder_at_hand.h"
#include "volume/reading/decoder_start.h"
#include "volume/reading/read_volume.h"

#include "pretended_decoder.h"

#include <sys/prctl.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <chrono>
#include <csignal>
#include <fstream>
#include <functional>
#include <thread>

namespace vs::volume {
namespace {

// Waits until something is so, which it is sooner or later unless the test fails.
void waitUntil(const std::function<bool()>& isSo) {
    constexpr int most = 60'000;
    for (int i = 0; i < most && !isSo(); ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    ASSERT_TRUE(isSo());
}

// Each decoder that is started writes its number to a file, then is the real one.
class CountedDecoders {
public:
    explicit CountedDecoders(const TemporaryFolder& folder)
        : file_(folder / "started"),
          pretended_(folder, "echo $$ >> " + file_.string() + "; exec " + decoderProgram().string()) {}

    [[nodiscard]] std::vector<pid_t> started() const {
        std::vector<pid_t> numbers;
        std::ifstream file(file_);
        for (pid_t number = 0; file >> number;) {
            numbers.push_back(number);
        }
        return numbers;
    }

private:
    std::filesystem::path file_;
    PretendedDecoder pretended_;
};

pid_t waitForOne(const DecoderAtHand& decoder) {
    waitUntil([&] { return decoder.waiting() != 0; });
    return decoder.waiting();
}

TEST(DecoderAtHand, IsUsedOnceAndAnotherOneComesInItsPlace) {
    const TemporaryFolder folder;
    const auto path = cube(folder, 9);
    {
        const CountedDecoders counted(folder);
        const DecoderAtHand decoder;
        std::vector<pid_t> expected;
        for (int round = 0; round < 3; ++round) {
            expected.push_back(waitForOne(decoder));
            waitUntil([&] { return counted.started().size() == expected.size(); });
            EXPECT_EQ(readVolume(path).volume.geometry.dims, glm::ivec3(9));
        }
        expected.push_back(waitForOne(decoder));
        waitUntil([&] { return counted.started().size() >= expected.size(); });
        EXPECT_EQ(counted.started(), expected) << "each reading has started another one";
    }
    EXPECT_FALSE(hasChildren());
}

TEST(DecoderAtHand, MayEndStopOrBeReplacedWhileItWaits) {
    const TemporaryFolder folder;
    const auto path = cube(folder, 9);
    {
        const PretendedDecoder real(folder, "exec " + decoderProgram().string());
        const DecoderAtHand decoder;
        for (const int signal : {SIGKILL, SIGABRT, SIGSTOP}) {
            const pid_t waiting = waitForOne(decoder);
            ASSERT_EQ(kill(waiting, signal), 0);
            siginfo_t happened{};
            waitid(P_PID, id_t(waiting), &happened, WEXITED | WSTOPPED | WNOWAIT);
            EXPECT_EQ(readVolume(path).volume.geometry.dims, glm::ivec3(9)) << signal;
        }
        waitForOne(decoder);
        std::filesystem::rename(script(folder, "another", "exit 7"), folder / "decoder");
        EXPECT_THROW(readVolume(path), ReadError) << "what is installed now is what reads";
    }
    EXPECT_FALSE(hasChildren());
}

TEST(DecoderAtHand, ThatCannotBeStartedIsToldByWhoReads) {
    const TemporaryFolder folder;
    const auto path = cube(folder, 4);
    const std::string real = "exec " + decoderProgram().string();
    const PretendedDecoder pretended(folder, real);
    std::filesystem::remove(folder / "decoder");
    const DecoderAtHand decoder;
    EXPECT_THROW(readVolume(path), Error);
    std::filesystem::rename(script(folder, "another", real), folder / "decoder");
    EXPECT_EQ(readVolume(path).volume.geometry.dims, glm::ivec3(4));
}

// Threads come and go; a decoder that one of them has brought about stays.
TEST(DecoderAtHand, ServesThreadsThatReadAtOneTime) {
    const TemporaryFolder folder;
    const auto small = cube(folder, 9, "small.nrrd");
    const auto large = cube(folder, 64, "large.nrrd");
    {
        const DecoderAtHand decoder;
        std::atomic<int> right = 0;
        constexpr int rounds = 5;
        for (int round = 0; round < rounds; ++round) {
            const auto read = [&](const std::filesystem::path& path, int edge) {
                right += readVolume(path).volume.geometry.dims == glm::ivec3(edge) ? 1 : 0;
            };
            const std::jthread one(read, small, 9);
            const std::jthread other(read, large, 64);
        }
        EXPECT_EQ(right, 2 * rounds);
        EXPECT_EQ(readVolume(small).volume.geometry.dims, glm::ivec3(9));
    }
    EXPECT_FALSE(hasChildren());
}

// However the program ends, the decoder that waits does too.
TEST(DecoderAtHand, EndsWithTheProgram) {
    prctl(PR_SET_CHILD_SUBREAPER, 1); // who loses its parent becomes a child of this process
    std::array<int, 2> told{};
    ASSERT_EQ(pipe(told.data()), 0);
    const pid_t program = fork();
    if (program == 0) {
        const DecoderAtHand decoder;
        const pid_t waiting = waitForOne(decoder);
        const bool isTold = write(told[1], &waiting, sizeof waiting) == sizeof waiting;
        kill(getpid(), isTold ? SIGKILL : SIGTERM);
    }
    pid_t waiting = 0;
    ASSERT_EQ(read(told[0], &waiting, sizeof waiting), ssize_t(sizeof waiting));
    int status = 0;
    EXPECT_EQ(waitpid(program, &status, 0), program);
    EXPECT_EQ(waitpid(waiting, &status, 0), waiting) << "the test would wait here until it ends";
    close(told[0]);
    close(told[1]);
    prctl(PR_SET_CHILD_SUBREAPER, 0);
    EXPECT_FALSE(hasChildren());
}

} // namespace
} // namespace vs::volume
