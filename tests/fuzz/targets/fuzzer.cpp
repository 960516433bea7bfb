// SPDX-License-Identifier: Apache-2.0
// The targets under libFuzzer: fuzz --target=NAME [what libFuzzer takes]. tests/fuzz/run starts it.
#include "target.h"

#include <pthread.h>
#include <sanitizer/common_interface_defs.h>

#include <array>
#include <csignal>
#include <cstdlib>

namespace {

vs::fuzz::Target chosen{};

// GDCM decodes pixels in forked children, which may crash: that is what they are for. libFuzzer would take it
// for a finding.
void letChildrenCrash() {
    for (const int signal : std::array{SIGSEGV, SIGBUS, SIGABRT, SIGILL, SIGFPE, SIGALRM}) {
        std::signal(signal, SIG_DFL);
    }
    __sanitizer_set_death_callback(nullptr);
}

} // namespace

// Names that libFuzzer gives.
// NOLINTNEXTLINE(readability-identifier-naming)
extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
    constexpr std::string_view flag = "--target=";
    std::string_view name;
    for (int i = 1; i < *argc; ++i) {
        const std::string_view word = (*argv)[i];
        name = word.starts_with(flag) ? word.substr(flag.size()) : name;
    }
    chosen = vs::fuzz::targetNamed(name);
    vs::fuzz::keepErrorOutput();
    setenv("VOLUME_STUDIO_LOG", "debug", 1); // or a sanitizer's report within a library would go to nowhere
    pthread_atfork(nullptr, nullptr, letChildrenCrash);
    return 0;
}

// NOLINTNEXTLINE(readability-identifier-naming)
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    chosen.read({data, size});
    return 0;
}
