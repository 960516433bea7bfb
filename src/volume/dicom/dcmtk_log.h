// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <dcmtk/config/osconfig.h> // DCMTK wants it first

#include <dcmtk/oflog/oflog.h>

#include <mutex>

namespace vs::volume {

// DCMTK's own lines on the error output stop: what matters is said by exceptions.
inline void silenceDcmtk() {
    static std::once_flag once;
    std::call_once(once, [] { OFLog::configure(OFLogger::OFF_LOG_LEVEL); });
}

} // namespace vs::volume
