// SPDX-License-Identifier: Apache-2.0
#include "model/texts/operation_texts.h"

#include "model/texts/library_texts.h"

namespace vs::desktop {

QString describe(const studio::Operation& operation) {
    const QString name = libraryText(studio::name(operation));
    QString text = name.left(1).toUpper() + name.mid(1);
    for (const Phrase& detail : studio::details(operation)) {
        text += ", " + libraryText(detail);
    }
    return text;
}

const char* iconName(const studio::Operation& operation) { return studio::about(operation).icon; }

} // namespace vs::desktop
