// SPDX-License-Identifier: Apache-2.0
#include "volume/io/quiet_libraries.h"

#include "base/log.h"
#include "volume/io/inspect.h"

#include <itkMacro.h>
#include <itkObject.h>

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>

namespace vs::volume {
namespace {

int redirect(int descriptor) {
    const int saved = dup(descriptor);
    const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
    if (saved >= 0 && nowhere >= 0) {
        dup2(nowhere, descriptor);
    }
    if (nowhere >= 0) {
        close(nowhere);
    }
    return saved;
}

void restore(int saved, int descriptor) {
    if (saved >= 0) {
        dup2(saved, descriptor);
        close(saved);
    }
}

} // namespace

QuietLibraries::QuietLibraries() {
    itk::Object::GlobalWarningDisplayOff();
    if (!isLogged(LogLevel::Debug)) {
        std::fflush(stdout);
        savedError_ = redirect(STDERR_FILENO);
        savedOutput_ = redirect(STDOUT_FILENO);
    }
}

QuietLibraries::~QuietLibraries() {
    if (savedOutput_ >= 0) {
        std::fflush(stdout);
    }
    restore(savedError_, STDERR_FILENO);
    restore(savedOutput_, STDOUT_FILENO);
}

std::string shortReason(const std::exception& error) {
    std::string text = error.what();
    if (const auto* itkError = dynamic_cast<const itk::ExceptionObject*>(&error)) {
        text = itkError->GetDescription();
    }
    if (const auto colon = text.find("): "); text.starts_with("ITK ERROR: ") && colon != std::string::npos) {
        text = text.substr(colon + 3);
    }
    text = trimmed(text);
    for (char& c : text) {
        c = c == '\n' ? ' ' : c;
    }
    return printable(text);
}

} // namespace vs::volume
