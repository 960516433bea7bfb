// SPDX-License-Identifier: Apache-2.0
#pragma once

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
// file. The values come back through shared memory. Children are forked, so the process that decodes has no
// other threads (the decoder, apps/decoder).
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
        std::size_t offset = 0; // of its values in the shared memory
        std::size_t bytes = 0;  // reserved there
    };

    void decode(const Job& job, Record& record) const;
    void waitFor(std::vector<pid_t> children) const;
    void runChild(std::size_t first, std::size_t step) const;
    [[nodiscard]] Record& recordOf(std::size_t job) const;
    void release();

    std::vector<Job> jobs_;
    std::map<std::filesystem::path, std::size_t> jobOf_;
    std::byte* shared_ = nullptr; // records, then values
    std::size_t sharedBytes_ = 0;
};

} // namespace vs::volume
