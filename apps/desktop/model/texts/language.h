// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QLocale>
#include <QString>

class QCoreApplication;

namespace vs::desktop {

// The language that the window speaks. Texts are made in English and translated where they are shown.
enum class Language { Desktop, English, German };

// Makes tr() and Qt's own texts speak it. Before the first widget: those that are there keep their texts.
void speak(QCoreApplication& application, Language language);

// The locale of the texts, for dates. Numbers have points in every language, as in boxes, session files and
// tables.
QLocale textLocale();

} // namespace vs::desktop
