// SPDX-License-Identifier: Apache-2.0
#include "volume/dicom/isolated_decode.h"

#include "base/large_pages.h"
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
#include <stdexcept>
#include <thread>
#include <utility>

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
    const std::size_t workers =
        std::min<std::size_t>(jobs_.size(), std::clamp(std::thread::hardware_concurrency(), 1U, 16U));
    for (std::size_t worker = 0; worker < workers; ++worker) {
        values_.emplace_back(memfd_create("values", MFD_CLOEXEC));
        std::size_t offset = 0;
        for (std::size_t i = worker; i < jobs_.size(); i += workers) {
            Job& job = jobs_[i];
            // Room for the widest type; what is not written there costs nothing.
            job.bytes = checkedBytes(path, {job.slice.size.x, job.slice.size.y, job.slice.frameCount},
                                     sizeof(double));
            job.worker = worker;
            job.offset = std::exchange(offset, offset + job.bytes);
        }
    }
    void* memory = mmap(nullptr, jobs_.size() * sizeof(Record), PROT_READ | PROT_WRITE,
                        MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) {
        throw std::bad_alloc();
    }
    records_ = new (memory) Record[jobs_.size()];

    std::vector<pid_t> children;
    for (std::size_t worker = 0; worker < workers; ++worker) {
        const pid_t child = fork();
        if (child == 0) {
            runChild(worker);
            leave();
        }
        if (child > 0) {
            children.push_back(child);
        }
    }
    waitFor(std::move(children));
    for (std::size_t job = 0; job < jobs_.size(); ++job) {
        const Record& record = records_[job];
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
            done += records_[job].done ? 1 : 0;
        }
        reportProgress(kDecoding * double(done) / double(jobs_.size()));
        nanosleep(&moment, nullptr);
    }
}

void IsolatedDecoder::release() {
    if (records_ != nullptr) {
        munmap(records_, jobs_.size() * sizeof(Record));
        records_ = nullptr;
    }
}

void IsolatedDecoder::runChild(std::size_t worker) const {
    constexpr unsigned longest = 120; // seconds for one file; a decoder that hangs ends with the alarm
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    const QuietLibraries quiet;
    std::vector<std::byte> values;
    for (std::size_t job = worker; job < jobs_.size(); job += values_.size()) {
        alarm(longest);
        Record& record = records_[job];
        try {
            decode(jobs_[job], record, values);
        } catch (const std::exception& error) {
            const auto reason = shortReason(error);
            std::strncpy(record.reason.data(), reason.empty() ? "unknown cause" : reason.c_str(),
                         record.reason.size() - 1);
        }
        record.done = true;
    }
    leave();
}

// Uses `values` for what it has decoded; what was in it does not matter.
void IsolatedDecoder::decode(const Job& job, Record& record, std::vector<std::byte>& values) const {
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
    values.resize(record.bytes);
    io->Read(values.data());
    for (std::size_t at = 0; at < record.bytes;) {
        const ssize_t written = pwrite(values_[job.worker].number(), values.data() + at, record.bytes - at,
                                       off_t(job.offset + at));
        if (written < 0 && errno != EINTR) {
            throw std::bad_alloc();
        }
        at += std::size_t(std::max<ssize_t>(written, 0));
    }
    record.component = io->GetComponentType();
    record.slope = io->GetRescaleSlope();
    record.intercept = io->GetRescaleIntercept();
}

DecodedFile IsolatedDecoder::take(const DicomSlice& slice) const {
    const std::size_t job = jobOf_.at(slice.file);
    const Record& record = records_[job];
    DecodedFile decoded;
    decoded.file = slice.file;
    decoded.values.geometry.dims = {slice.size, slice.frameCount};
    decoded.scale = {record.slope, record.intercept};
    std::vector<std::byte> values;
    reserveInLargePages(values, record.bytes);
    values.resize(record.bytes);
    for (std::size_t at = 0; at < record.bytes;) {
        const ssize_t count = pread(values_[jobs_[job].worker].number(), values.data() + at,
                                    record.bytes - at, off_t(jobs_[job].offset + at));
        if (count == 0 || (count < 0 && errno != EINTR)) {
            throw std::runtime_error("its pixels are not there");
        }
        at += std::size_t(std::max<ssize_t>(count, 0));
    }
    takeValues(decoded.values, storedTypeOf(record.component), std::move(values));
    return decoded;
}

} // namespace vs::volume
