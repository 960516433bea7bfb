// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace vs::decoder {

// From here on this process, and those that it forks, can open files for reading only, and can neither start
// programs nor use a network nor look into other processes, by libseccomp. Without effect where the kernel
// has no such filters.
void closeSandbox();

} // namespace vs::decoder
