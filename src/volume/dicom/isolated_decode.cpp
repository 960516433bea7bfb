// SPDX-License-Identifier: Apache-2.0
#include "volume/dicom/isolated_decode.h"

#include "base/progress.h"
#include "volume/io/inspect.h"
#include "volume/io/quiet_libraries.h"
#include "volume/io/take_values.h"

#include <fmt/format.h>
#include <itkGDCMImageIO.h>

#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <ctime>
#include <thread>

namespace vs::volume {

// What a child leaves behind about one file. Lies in shared memory: plain data only.
struct IsolatedDecoder::Record {
    std::atomic<bool> done = false; // free of locks, so that it works between processes
    itk::IOComponentEnum component = itk::IOComponentEnum::UNKNOWNCOMPONENTTYPE;
    std::size_t bytes = 0;
    double slope = 1;
    double intercept = 0;
    std::array<char, 120> reason{}; // why it failed; empty if it did not
};

namespace {

constexpr std::size_t pageBytes = 4096;
std::size_t roundUp(std::size_t bytes) { return (bytes + pageBytes - 1) / pageBytes * pageBytes; }

StoredType storedTypeOf(itk::IOComponentEnum component) {
    using enum itk::CommonEnums::IOComponent;
    switch (component) {
    case UCHAR:
        return StoredType::UInt8;
    case CHAR:
        return StoredType::Int8;
    case USHORT:
        return StoredType::UInt16;
    case SHORT:
        return StoredType::Int16;
    case UINT:
        return StoredType::UInt32;
    case INT:
        return StoredType::Int32;
    case FLOAT:
        return StoredType::Float32;
    case DOUBLE:
        return StoredType::Float64;
    default:
        throw std::runtime_error("a data type that is not read here");
    }
}

// Ends a child, which never returns into the caller's code: without destructors, and without writing out what
// the parent had buffered.
[[noreturn]] void leave() { _exit(0); }

} // namespace

IsolatedDecoder::IsolatedDecoder(const std::filesystem::path& path, const std::vector<DicomSlice>& slices) {
    for (const auto& slice : slices) {
        if (jobOf_.emplace(slice.file, jobs_.size()).second) {
            jobs_.push_back({.slice = slice});
        }
    }
    sharedBytes_ = roundUp(jobs_.size() * sizeof(Record));
    for (auto& job : jobs_) {
        // Room for the widest type; pages that stay untouched cost nothing.
        job.bytes =
            checkedBytes(path, {job.slice.size.x, job.slice.size.y, job.slice.frameCount}, sizeof(double));
        job.offset = sharedBytes_;
        sharedBytes_ += roundUp(job.bytes);
    }
    void* memory = mmap(nullptr, sharedBytes_, PROT_READ | PROT_WRITE,
                        MAP_SHARED | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (memory == MAP_FAILED) {
        throw std::bad_alloc();
    }
    shared_ = static_cast<std::byte*>(memory);
    for (std::size_t job = 0; job < jobs_.size(); ++job) {
        new (shared_ + job * sizeof(Record)) Record;
    }

    const std::size_t workers =
        std::min<std::size_t>(jobs_.size(), std::clamp(std::thread::hardware_concurrency(), 1U, 16U));
    std::vector<pid_t> children;
    for (std::size_t worker = 0; worker < workers; ++worker) {
        const pid_t child = fork();
        if (child == 0) {
            runChild(worker, workers);
            leave();
        }
        if (child > 0) {
            children.push_back(child);
        }
    }
    waitFor(std::move(children));
    for (std::size_t job = 0; job < jobs_.size(); ++job) {
        const Record& record = recordOf(job);
        if (!record.done || record.reason[0] != '\0') {
            const std::string reason = record.done ? record.reason.data() : "the decoder gave up";
            const auto file = jobs_[job].slice.file;
            release();
            refuse(file, fmt::format("its pixels cannot be decoded ({})", reason),
                   "get an intact copy or decompress the file");
        }
    }
}

IsolatedDecoder::~IsolatedDecoder() { release(); }

void IsolatedDecoder::waitFor(std::vector<pid_t> children) const {
    constexpr timespec moment{0, 2'000'000};
    while (true) {
        std::erase_if(children, [](pid_t child) {
            const pid_t found = waitpid(child, nullptr, WNOHANG);
            return found == child || (found < 0 && errno != EINTR);
        });
        if (children.empty()) {
            return;
        }
        std::size_t done = 0;
        for (std::size_t job = 0; job < jobs_.size(); ++job) {
            done += recordOf(job).done ? 1 : 0;
        }
        reportProgress(kDecoding * double(done) / double(jobs_.size()));
        nanosleep(&moment, nullptr);
    }
}

void IsolatedDecoder::release() {
    if (shared_ != nullptr) {
        munmap(shared_, sharedBytes_);
        shared_ = nullptr;
    }
}

IsolatedDecoder::Record& IsolatedDecoder::recordOf(std::size_t job) const {
    return *std::launder(reinterpret_cast<Record*>(shared_ + job * sizeof(Record)));
}

void IsolatedDecoder::runChild(std::size_t first, std::size_t step) const {
    constexpr unsigned longest = 120; // seconds for one file; a decoder that hangs ends with the alarm
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    const QuietLibraries quiet;
    for (std::size_t job = first; job < jobs_.size(); job += step) {
        alarm(longest);
        Record& record = recordOf(job);
        try {
            decode(jobs_[job], record);
        } catch (const std::exception& error) {
            const auto reason = shortReason(error);
            std::strncpy(record.reason.data(), reason.empty() ? "unknown cause" : reason.c_str(),
                         record.reason.size() - 1);
        }
        record.done = true;
    }
    leave();
}

void IsolatedDecoder::decode(const Job& job, Record& record) const {
    const auto io = itk::GDCMImageIO::New();
    io->SetFileName(job.slice.file.string());
    io->ReadImageInformation();
    itk::ImageIORegion region(io->GetNumberOfDimensions());
    std::size_t count = io->GetNumberOfComponents();
    for (unsigned axis = 0; axis < io->GetNumberOfDimensions(); ++axis) {
        region.SetSize(axis, io->GetDimensions(axis));
        count *= io->GetDimensions(axis);
    }
    record.bytes = count * io->GetComponentSize();
    if (count * sizeof(double) != job.bytes || record.bytes > job.bytes ||
        io->GetDimensions(0) != std::size_t(job.slice.size.x) ||
        io->GetDimensions(1) != std::size_t(job.slice.size.y)) {
        throw std::runtime_error("its header is ambiguous");
    }
    io->SetIORegion(region);
    io->Read(shared_ + job.offset);
    record.component = io->GetComponentType();
    record.slope = io->GetRescaleSlope();
    record.intercept = io->GetRescaleIntercept();
}

DecodedFile IsolatedDecoder::take(const DicomSlice& slice) const {
    const std::size_t job = jobOf_.at(slice.file);
    const Record& record = recordOf(job);
    const std::byte* values = shared_ + jobs_[job].offset;
    DecodedFile decoded;
    decoded.file = slice.file;
    decoded.values.geometry.dims = {slice.size, slice.frameCount};
    decoded.scale = {record.slope, record.intercept};
    takeValues(decoded.values, storedTypeOf(record.component),
               std::vector<std::byte>(values, values + record.bytes));
    return decoded;
}

} // namespace vs::volume
