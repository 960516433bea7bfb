// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QToolButton>

namespace vs::desktop {

class Notices;

// Stands in the status bar while there are notices of reading that nobody has read, and says how many.
class NoticesBadge : public QToolButton {
    Q_OBJECT

public:
    // The notices must outlive it.
    explicit NoticesBadge(const Notices& notices, QWidget* parent = nullptr);

private:
    void refresh();

    const Notices& notices_;
};

} // namespace vs::desktop
