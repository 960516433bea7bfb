// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "engine/volume_loader.h"

#include <QString>

class QCoreApplication;

namespace vs::desktop {

// The command line. Prints help or version and ends the program when asked for them; throws UsageError.
struct Options {
    OpenRequest open; // both paths empty: nothing to open
    std::filesystem::path layoutFile;
    std::filesystem::path timingsFile;
    studio::MemoryBudgets budgets;
};

Options parseOptions(const QCoreApplication& application);

} // namespace vs::desktop
