// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

namespace vs::desktop {

// What is shown before a volume is open.
class WelcomePage : public QWidget {
    Q_OBJECT

public:
    explicit WelcomePage(QWidget* parent = nullptr);

signals:
    void openRequested();
    void openFolderRequested();
};

} // namespace vs::desktop
