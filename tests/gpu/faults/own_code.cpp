// SPDX-License-Identifier: Apache-2.0
#include "gpu/faults/own_code.h"

#include <elf.h>
#include <execinfo.h>
#include <fcntl.h>
#include <link.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string_view>

namespace vs::test {

namespace {

// The functions of this program by where they begin: its own symbol table, with those that no other file
// sees.
class Functions {
public:
    Functions() {
        const int file = ::open("/proc/self/exe", O_RDONLY | O_CLOEXEC);
        struct stat status {};
        if (file < 0 || ::fstat(file, &status) != 0) {
            std::abort();
        }
        void* all = ::mmap(nullptr, std::size_t(status.st_size), PROT_READ, MAP_PRIVATE, file, 0);
        ::close(file);
        image_ = static_cast<const char*>(all);
        read();
        ::dl_iterate_phdr(
            [](dl_phdr_info* info, std::size_t, void* self) {
                static_cast<Functions*>(self)->loadedAt_ = info->dlpi_addr;
                return 1; // the first one is the program
            },
            this);
    }

    // The mangled name of the function at an address; empty: it is not in this program.
    [[nodiscard]] std::string_view at(const void* address) const {
        const std::uint64_t place = reinterpret_cast<std::uintptr_t>(address) - loadedAt_;
        const auto* after = std::upper_bound(
            functions_, functions_ + count_, place,
            [](std::uint64_t value, const Elf64_Sym* symbol) { return value < symbol->st_value; });
        if (after == functions_) {
            return {};
        }
        const Elf64_Sym& found = **(after - 1);
        return place < found.st_value + found.st_size ? std::string_view(names_ + found.st_name)
                                                      : std::string_view();
    }

private:
    void read() {
        const auto* header = reinterpret_cast<const Elf64_Ehdr*>(image_);
        const auto* sections = reinterpret_cast<const Elf64_Shdr*>(image_ + header->e_shoff);
        const auto* table = std::find_if(sections, sections + header->e_shnum, [](const Elf64_Shdr& section) {
            return section.sh_type == SHT_SYMTAB;
        });
        if (table == sections + header->e_shnum) {
            std::abort(); // stripped
        }
        names_ = image_ + sections[table->sh_link].sh_offset;
        const auto* symbols = reinterpret_cast<const Elf64_Sym*>(image_ + table->sh_offset);
        const std::size_t all = table->sh_size / sizeof(Elf64_Sym);
        functions_ = static_cast<const Elf64_Sym**>(std::malloc(all * sizeof(Elf64_Sym*)));
        for (std::size_t n = 0; n < all; ++n) {
            if (ELF64_ST_TYPE(symbols[n].st_info) == STT_FUNC && symbols[n].st_size > 0) {
                functions_[count_++] = &symbols[n];
            }
        }
        std::sort(functions_, functions_ + count_,
                  [](const Elf64_Sym* a, const Elf64_Sym* b) { return a->st_value < b->st_value; });
    }

    const char* image_ = nullptr;
    const char* names_ = nullptr;
    const Elf64_Sym** functions_ = nullptr;
    std::size_t count_ = 0;
    std::uint64_t loadedAt_ = 0;
};

enum class Whose : std::uint8_t { Unknown, Passed, Own, Library };

// By the name: `Passed` is code of a library that ours calls by, and who called that one counts.
Whose whoseIs(std::string_view name) {
    if (name.empty()) {
        return Whose::Library;
    }
    const auto begins = [&](std::string_view with) { return name.substr(0, with.size()) == with; };
    // Operator new and what is in std and fmt.
    if (begins("_Zn") || begins("_ZNSt") || begins("_ZNKSt") || begins("_ZSt") || begins("_ZN3fmt") ||
        begins("_ZNK3fmt") || begins("_ZZNSt") || begins("_ZZNKSt") || begins("_ZN9__gnu_cxx")) {
        return Whose::Passed;
    }
    const bool isLibrarys = name.find("nlohmann") != std::string_view::npos || begins("_ZN3itk") ||
                            begins("_ZNK3itk") || name.find("rapidcheck") != std::string_view::npos;
    return isLibrarys ? Whose::Library : Whose::Own;
}

// What is in a shared library: the standard library and libfmt are passed.
Whose whoseIsShared(const void* address) {
    Dl_info info{};
    if (::dladdr(address, &info) == 0 || info.dli_fname == nullptr) {
        return Whose::Library;
    }
    const std::string_view file(info.dli_fname);
    return file.find("libstdc++") != std::string_view::npos || file.find("libfmt") != std::string_view::npos
               ? Whose::Passed
               : Whose::Library;
}

// Remembered for each address from which something was called.
Whose whose(const void* address) {
    struct Known {
        std::atomic<const void*> address = nullptr;
        std::atomic<Whose> whose = Whose::Unknown;
    };
    static std::array<Known, 1 << 16> table;
    static const Functions functions;
    Known& known = table[(reinterpret_cast<std::uintptr_t>(address) * 0x9e3779b97f4a7c15U) >> 48U];
    if (known.address.load() == address && known.whose.load() != Whose::Unknown) {
        return known.whose.load();
    }
    const std::string_view name = functions.at(address);
    const Whose found = name.empty() ? whoseIsShared(address) : whoseIs(name);
    known.whose.store(Whose::Unknown);
    known.address.store(address);
    known.whose.store(found);
    return found;
}

} // namespace

bool isCalledByOwnCode() {
    std::array<void*, 24> frames{};
    const int count = ::backtrace(frames.data(), int(frames.size()));
    for (int n = 1; n < count; ++n) {
        const auto* call = static_cast<const char*>(frames[std::size_t(n)]) - 1; // it returns after the call
        const Whose found = whose(call);
        if (found != Whose::Passed) {
            return found == Whose::Own;
        }
    }
    return false;
}

} // namespace vs::test
