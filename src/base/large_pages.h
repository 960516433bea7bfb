// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace vs {

// Asks for memory that has not been touched yet to be made of large pages, where the system has them and they
// are worth it. Memory costs the more the more pages it has when it is touched for the first time: 64 MiB
// take 20 ms in pages of 4 KiB and 3 ms in those of 2 MiB.
void askForLargePages(std::span<std::byte> memory);

// Makes room for so many bytes in such pages. Throws std::bad_alloc.
void reserveInLargePages(std::vector<std::byte>& bytes, std::size_t count);

// From now on freed memory stays with the program, up to 128 MiB of it, for whatever is asked for next: what
// comes from the system is touched for the first time each time. Call it when the program begins.
void keepFreedMemory();

} // namespace vs
