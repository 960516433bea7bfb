// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>

class QMainWindow;

namespace vs::desktop {

// All keyboard shortcuts of a window, by its menus, and what the mouse does. Made from the actions
// themselves, so none is missing.
class ShortcutSheet : public QDialog {
    Q_OBJECT

public:
    // Deletes itself when it closes.
    explicit ShortcutSheet(QMainWindow& window);
};

} // namespace vs::desktop
