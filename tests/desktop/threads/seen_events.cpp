// SPDX-License-Identifier: Apache-2.0
#include "seen_events.h"

#ifdef __SANITIZE_THREAD__
#include <sanitizer/tsan_interface.h>
#endif

namespace {

[[maybe_unused]] char queue; // stands for that of Qt's events

void given() {
#ifdef __SANITIZE_THREAD__
    __tsan_release(&queue);
#endif
}

void taken() {
#ifdef __SANITIZE_THREAD__
    __tsan_acquire(&queue);
#endif
}

} // namespace

// The linker (--wrap, CMakeLists.txt) gives our calls of QMetaObject::invokeMethodImpl() the second of these,
// and calls of the first go to Qt. NOLINTBEGIN
extern "C" {
#define VS_INVOKE(prefix)                                                                                    \
    prefix##_ZN11QMetaObject16invokeMethodImplEP7QObjectPN9QtPrivate15QSlotObjectBaseEN2Qt14ConnectionTypeEPv
bool VS_INVOKE(__real_)(QObject* object, QtPrivate::QSlotObjectBase* slot, Qt::ConnectionType type,
                        void* result);
bool VS_INVOKE(__wrap_)(QObject* object, QtPrivate::QSlotObjectBase* slot, Qt::ConnectionType type,
                        void* result) {
    given();
    return VS_INVOKE(__real_)(object, slot, type, result);
}
}
// NOLINTEND

bool vs::desktop::SeenApplication::notify(QObject* receiver, QEvent* event) {
    taken();
    return QApplication::notify(receiver, event);
}
