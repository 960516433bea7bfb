// SPDX-License-Identifier: Apache-2.0
#include "model/texts/language.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QTranslator>

namespace vs::desktop {

namespace {

QLocale spoken(QLocale::English); // set once, by speak()

bool isGerman(Language language) {
    // The person's order of languages: German counts where it comes before English.
    const QStringList wanted = QLocale::system().uiLanguages();
    const QString first = wanted.isEmpty() ? QString() : wanted.front();
    return language == Language::German ||
           (language == Language::Desktop && (first == "de" || first.startsWith("de-")));
}

} // namespace

void speak(QCoreApplication& application, Language language) {
    if (!isGerman(language)) {
        return;
    }
    spoken = QLocale(QLocale::German);
    auto* qt = new QTranslator(&application); // of its dialogs; where Debian's qt6-translations-l10n is
    if (qt->load(spoken, "qtbase", "_", QLibraryInfo::path(QLibraryInfo::TranslationsPath))) {
        QCoreApplication::installTranslator(qt);
    }
    auto* own = new QTranslator(&application);
    if (own->load(":/translations/volume-studio_de.qm")) {
        QCoreApplication::installTranslator(own);
    }
}

QLocale textLocale() { return spoken; }

} // namespace vs::desktop
