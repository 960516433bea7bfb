// SPDX-License-Identifier: Apache-2.0
// Memory that is refused, for tests of what becomes of an operation then.
#pragma once

#include <cstddef>

namespace vs::test {

enum class Memory {
    Host,  // operator new, where this project's own code asks for it, also through the standard library
    Device // storage of textures and buffers
};

// While it exists, one allocation of a kind is refused: the one with this number, counted from 1; 0: none.
// Allocations of libraries are neither counted nor refused, nor is what a destructor of theirs needs. One at
// a time.
class RefusedAllocation {
public:
    RefusedAllocation(Memory memory, std::size_t number);
    ~RefusedAllocation();
    RefusedAllocation(const RefusedAllocation&) = delete;
    RefusedAllocation& operator=(const RefusedAllocation&) = delete;

    // How many there have been, the refused one included, and whether that came.
    [[nodiscard]] std::size_t count() const;
    [[nodiscard]] bool hasHappened() const;

private:
    std::size_t number_;
};

} // namespace vs::test
