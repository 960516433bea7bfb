// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QColor>

class QApplication;

namespace vs::desktop {

// A dark, calm window, so that the picture is the brightest thing in it. Accents are of the Okabe-Ito
// palette, which colour-blind people can tell apart.
namespace theme {

inline const QColor kWindow{0x1f, 0x22, 0x26};
inline const QColor kPanel{0x26, 0x2a, 0x2f};
inline const QColor kField{0x18, 0x1b, 0x1e};
inline const QColor kLine{0x3a, 0x40, 0x47};
inline const QColor kText{0xe3, 0xe6, 0xea};
inline const QColor kQuiet{0x9a, 0xa3, 0xad};
inline const QColor kDisabled{0x5f, 0x67, 0x70};
inline const QColor kAccent{0x56, 0xb4, 0xe9}; // sky blue
inline const QColor kIdle{0x2f, 0xc9,
                          0x8f}; // bluish green, lighter than the palette's to show on dark pictures
inline const QColor kCutting{0xe6, 0x4b, 0x1e};   // vermilion
inline const QColor kRestore{0x56, 0xb4, 0xe9};   // sky blue
inline const QColor kRestoring{0x1f, 0x86, 0xff}; // a deeper blue than the palette's sky blue
inline const QColor kSeed{0xf0, 0xe4, 0x42};      // yellow
inline const QColor kPen{0xff, 0xff, 0xff};

} // namespace theme

void applyTheme(QApplication& application);

} // namespace vs::desktop
