// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/child_process.h"
#include "volume/dicom/dicom.h"

#include <sys/types.h>

#include <map>

namespace vs::volume {

// A decoded file with all its frames.
struct DecodedFile {
    std::filesystem::path file;
    Volume values;          // dims, type and bytes
    glm::dvec2 scale{1, 0}; // slope and intercept that were applied to all frames
};

// Decodes the files of a series in child processes, one for each core. GDCM and the decoders behind it answer
// some damaged streams by aborting or worse; here that costs a child and becomes a ReadError that names the
// file. The values come back through a file in memory, written and read: memory that both have costs twice as
// much, page by page. Children are forked, so the process that decodes has no other threads (the decoder,
// apps/decoder).
class IsolatedDecoder {
public:
    static constexpr double kDecoding = 0.9; // the share of all the work
    // Decodes everything before it returns, and reports progress up to kDecoding. Throws ReadError naming the
    // first file that failed.
    IsolatedDecoder(const std::filesystem::path& path, const std::vector<DicomSlice>& slices);
    ~IsolatedDecoder();
    IsolatedDecoder(const IsolatedDecoder&) = delete;
    IsolatedDecoder& operator=(const IsolatedDecoder&) = delete;

    // The decoded file that the slice lies in.
    [[nodiscard]] DecodedFile take(const DicomSlice& slice) const;

private:
    struct Record;
    struct Job {
        DicomSlice slice;       // any of the file
        std::size_t worker = 0; // the number of the child that decodes it
        std::size_t offset = 0; // of its values in that child's file
        std::size_t bytes = 0;  // that it may take there
    };

    void decode(const Job& job, Record& record, std::vector<std::byte>& values) const;
    void waitFor(std::vector<pid_t> children) const;
    void runChild(std::size_t worker) const;
    void release();

    std::vector<Job> jobs_;
    std::map<std::filesystem::path, std::size_t> jobOf_;
    Record* records_ = nullptr;      // shared with the children, one for each job
    std::vector<Descriptor> values_; // a file for each child: writing to one file they wait for each other
};

} // namespace vs::volume
