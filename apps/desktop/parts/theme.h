// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QColor>

#include <optional>

class QApplication;

namespace vs::desktop {

enum class Theme; // model/settings/preferences.h

// The colours at present: applyTheme() sets them, so look each time something is painted. Accents are of the
// Okabe-Ito palette, which colour-blind people can tell apart.
namespace theme {

inline QColor kWindow{0x1f, 0x22, 0x26};
inline QColor kPanel{0x26, 0x2a, 0x2f};
inline QColor kField{0x18, 0x1b, 0x1e};
inline QColor kLine{0x3a, 0x40, 0x47};
inline QColor kText{0xe3, 0xe6, 0xea};
inline QColor kQuiet{0x9a, 0xa3, 0xad};
inline QColor kDisabled{0x5f, 0x67, 0x70};
inline QColor kAccent{0x56, 0xb4, 0xe9}; // sky blue

// Colours of what is drawn on the picture, which are the same in every theme.
inline const QColor kIdle{0x2f, 0xc9,
                          0x8f}; // bluish green, lighter than the palette's to show on dark pictures
inline const QColor kCutting{0xe6, 0x4b, 0x1e};   // vermilion
inline const QColor kRestore{0x56, 0xb4, 0xe9};   // sky blue
inline const QColor kRestoring{0x1f, 0x86, 0xff}; // a deeper blue than the palette's sky blue
inline const QColor kSeed{0xf0, 0xe4, 0x42};      // yellow
inline const QColor kPen{0xff, 0xff, 0xff};
inline const QColor kInterpolated{0xe6, 0x9f, 0x00}; // orange

} // namespace theme

// Colours the whole program, also while it runs. Desktop: dark or light as the desktop's own windows are.
void applyTheme(QApplication& application, Theme theme);

// The desktop is light or dark from now on; nothing: look at the colours that Qt takes from it. Changes the
// window only where its theme is the desktop's.
void setDesktopTheme(QApplication& application, std::optional<bool> isLight);
// What was heard last, whatever theme the window has.
[[nodiscard]] bool isDesktopLight();

} // namespace vs::desktop
