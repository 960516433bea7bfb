// SPDX-License-Identifier: Apache-2.0
#include "decoding_limits.h"

#include <sys/resource.h>
#include <sys/time.h>

#include <algorithm>
#include <cmath>

namespace vs::decoder {
namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kIsSanitized = true;
#else
constexpr bool kIsSanitized = false;
#endif

constexpr std::uint64_t kLeastBytes = std::uint64_t(192) << 20;
constexpr std::uint64_t kLeastPromise = std::uint64_t(128) << 20;
constexpr double kLeastSeconds = kIsSanitized ? 30 : 1.5;
constexpr double kSecondsPerByte = kIsSanitized ? 5e-6 : 250e-9;
constexpr double kSecondsPerFile = kIsSanitized ? 20e-3 : 1e-3;

// A volume may be what lies in a folder, or more than the file that it is opened by: slices, or values beside
// a header.
bool isOneFile(const std::filesystem::path& path) {
    const auto extension = path.extension().string();
    return extension == ".nii" || extension == ".gz" || extension == ".nrrd" || extension == ".mha" ||
           extension == ".vtk" || extension == ".raw" || extension == ".png" || extension == ".tif" ||
           extension == ".tiff";
}

// The hard limit stays what it is: one that was lowered cannot be raised again.
void setSoftLimit(__rlimit_resource_t resource, rlim_t wanted) {
    rlimit limit{};
    getrlimit(resource, &limit);
    limit.rlim_cur = std::min(wanted, limit.rlim_max);
    setrlimit(resource, &limit);
}

double secondsOf(const timeval& time) { return double(time.tv_sec) + 1e-6 * double(time.tv_usec); }

// What this process has used of the processor.
double secondsUsed() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return secondsOf(usage.ru_utime) + secondsOf(usage.ru_stime);
}

} // namespace

Limits::Limits(const std::filesystem::path& path) {
    std::error_code error;
    if (path.empty()) {
        files_ = 0;
    } else if (isOneFile(path) && std::filesystem::is_regular_file(path, error)) {
        fileBytes_ = std::filesystem::file_size(path, error);
    } else {
        const auto folder = std::filesystem::is_directory(path, error) ? path
                            : path.parent_path().empty()               ? std::filesystem::path(".")
                                                                       : path.parent_path();
        for (std::filesystem::directory_iterator it(folder, error), end; !error && it != end;
             it.increment(error)) {
            std::error_code unknown;
            const auto bytes = it->is_regular_file(unknown) ? it->file_size(unknown) : 0;
            fileBytes_ += unknown ? 0 : bytes;
            ++files_;
        }
    }
    const rlimit none{0, 0};
    setrlimit(RLIMIT_CORE, &none);
    set();
}

void Limits::promise(std::uint64_t bytes) {
    constexpr std::uint64_t most = std::uint64_t(1) << 50; // so that nothing overflows
    promisedBytes_ = std::min(most, promisedBytes_ + std::min(most, bytes));
    set();
}

void Limits::addFile(std::uint64_t bytes) {
    fileBytes_ += bytes;
    ++files_;
    set();
}

void Limits::set() const {
    const std::uint64_t promised = std::min(promisedBytes_, std::max(kLeastPromise, 1040 * fileBytes_));
    if (!kIsSanitized) {
        setSoftLimit(RLIMIT_DATA, kLeastBytes + 2 * fileBytes_ + 6 * promised);
    }
    const double seconds =
        kLeastSeconds + kSecondsPerByte * double(fileBytes_ + promised) + kSecondsPerFile * double(files_);
    const double left = std::max(0.01, seconds - secondsUsed());
    const itimerval timer{{0, 0}, {time_t(left), suseconds_t(1e6 * (left - std::floor(left)))}};
    setitimer(ITIMER_PROF, &timer, nullptr);
    // For the processes that it starts, which have no timer.
    setSoftLimit(RLIMIT_CPU, rlim_t(std::ceil(seconds)));
}

} // namespace vs::decoder
