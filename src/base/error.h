// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <string>

namespace vs {

// What a person can cause or mend: a wrong file, a full disk, a driver that cannot do what is needed. The
// text is one line that names the file or value, says what is wrong and what would be right. Thrown at
// boundaries only.
class Error : public std::runtime_error {
public:
    explicit Error(const std::string& message) : std::runtime_error(message) {}

    template <typename... Args>
    explicit Error(fmt::format_string<Args...> format, Args&&... args)
        : std::runtime_error(fmt::format(format, std::forward<Args>(args)...)) {}
};

// A file that cannot be read as what it claims to be.
class ReadError : public Error {
public:
    using Error::Error;
};

// A file that cannot be written.
class WriteError : public Error {
public:
    using Error::Error;
};

// A shader that does not compile or link, or a context that lacks what the program needs.
class GlError : public Error {
public:
    using Error::Error;
};

// The graphics driver was reset: all that was on the device is gone, and nothing can be done with it any
// more.
class ContextLost : public GlError {
public:
    using GlError::GlError;
};

// A command line or an option value that makes no sense. The command line exits with 2 for this one.
class UsageError : public Error {
public:
    using Error::Error;
};

// A session, or another JSON file of ours, whose content is wrong.
class SessionError : public Error {
public:
    using Error::Error;
};

} // namespace vs
