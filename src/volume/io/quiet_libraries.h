// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <exception>
#include <string>

// What libraries say. Internal to reading and writing.
namespace vs::volume {

// Sends what libraries print that read and write scans to nowhere while it lives: their causes reach the
// caller as exceptions, and standard error must hold our one line. Nothing is hidden when
// VOLUME_STUDIO_LOG=debug is set.
class QuietLibraries {
public:
    QuietLibraries();
    ~QuietLibraries();
    QuietLibraries(const QuietLibraries&) = delete;
    QuietLibraries& operator=(const QuietLibraries&) = delete;

private:
    int savedError_ = -1;
    int savedOutput_ = -1;
};

// The first line of an exception's text without the place in ITK's sources.
std::string shortReason(const std::exception& error);

} // namespace vs::volume
