// SPDX-License-Identifier: Apache-2.0
// Whose code asks for memory.
#pragma once

namespace vs::test {

// Whether the code that called, as the stack tells, is this project's own: what stands below the standard
// library and libfmt, which it calls by. Needs no operator new.
bool isCalledByOwnCode();

} // namespace vs::test
