// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QCoreApplication>
#include <QString>

#include <filesystem>

namespace vs::desktop {

// Texts of functions that belong to no QObject, in the person's language. The context is the one in which
// lupdate files them.
inline QString tr(const char* text) { return QCoreApplication::translate("vs::desktop", text); }

inline QString textOf(const std::filesystem::path& path) { return QString::fromStdString(path.string()); }
inline std::filesystem::path pathOf(const QString& text) { return {text.toStdString()}; }

} // namespace vs::desktop
