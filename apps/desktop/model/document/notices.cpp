// SPDX-License-Identifier: Apache-2.0
#include "model/document/notices.h"

namespace vs::desktop {

void Notices::add(const std::vector<std::string>& notices) {
    for (const std::string& notice : notices) {
        all_ << QString::fromStdString(notice);
    }
    unread_ += int(notices.size());
    if (!notices.empty()) {
        emit changed();
    }
}

void Notices::clear() {
    all_.clear();
    unread_ = 0;
    emit changed();
}

void Notices::markRead() {
    unread_ = 0;
    emit changed();
}

} // namespace vs::desktop
