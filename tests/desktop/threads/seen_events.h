// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QApplication>

namespace vs::desktop {

// An application whose calls from thread to thread ThreadSanitizer sees. Debian's Qt is not built with it, so
// that without this whatever is given to QMetaObject::invokeMethod() looks like a race. What two threads
// share without any such call is found all the same.
class SeenApplication : public QApplication {
public:
    using QApplication::QApplication;

    bool notify(QObject* receiver, QEvent* event) override;
};

} // namespace vs::desktop
