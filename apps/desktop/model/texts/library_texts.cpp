// SPDX-License-Identifier: Apache-2.0
#include "model/texts/library_texts.h"

#include <QCoreApplication>

#include <iterator>

namespace vs::desktop {

namespace {

// The presets of transfer functions are data, in which nothing can be marked.
constexpr const char* kPresetTexts[] = {
    QT_TRANSLATE_NOOP("library", "CT bone"),
    QT_TRANSLATE_NOOP("library", "Skeleton alone; Hounsfield units"),
    QT_TRANSLATE_NOOP("library", "CT bone, surfaces"),
    QT_TRANSLATE_NOOP("library", "Bone's surface by its steep edge, marrow faint inside; Hounsfield units"),
    QT_TRANSLATE_NOOP("library", "CT skin"),
    QT_TRANSLATE_NOOP("library", "The skin's surface, opaque; Hounsfield units"),
    QT_TRANSLATE_NOOP("library", "CT skin, muscle and bone"),
    QT_TRANSLATE_NOOP("library", "Skin as a thin veil, muscle and bone by their edges; Hounsfield units"),
    QT_TRANSLATE_NOOP("library", "CT soft tissue"),
    QT_TRANSLATE_NOOP("library", "Muscle and organs, a veil of fat, bone behind; Hounsfield units"),
    QT_TRANSLATE_NOOP("library", "CT vessels"),
    QT_TRANSLATE_NOOP("library",
                      "Vessels filled with contrast medium, bone as a pale shell; Hounsfield units"),
    QT_TRANSLATE_NOOP("library", "Edges"),
    QT_TRANSLATE_NOOP("library", "Boundaries of any kind: the steeper, the denser; follows the gradients"),
    QT_TRANSLATE_NOOP("library", "Grey ramp"),
    QT_TRANSLATE_NOOP("library",
                      "Every value above air, evenly: grey and opacity rise together; follows the histogram"),
    QT_TRANSLATE_NOOP("library", "Microscopy"),
    QT_TRANSLATE_NOOP("library", "Fluorescence: bright is dense and glows; follows the histogram"),
    QT_TRANSLATE_NOOP("library", "MR angiography"),
    QT_TRANSLATE_NOOP("library", "Bright vessels from time-of-flight or contrast MR; follows the histogram"),
    QT_TRANSLATE_NOOP("library", "MR T1, skin and brain"),
    QT_TRANSLATE_NOOP(
        "library",
        "Skin as a veil by its edge, grey and white matter by their values; follows the histogram"),
    QT_TRANSLATE_NOOP("library", "MR T1 head"),
    QT_TRANSLATE_NOOP(
        "library",
        "Head from T1-weighted MR, nearly opaque: a cut shows grey and white matter; follows the histogram")};

} // namespace

QString libraryText(std::string_view english) {
    return QCoreApplication::translate("library", std::string(english).c_str());
}

QString libraryText(const Phrase& phrase) {
    Phrase said = phrase;
    const QByteArray text = libraryText(std::string_view(phrase.text)).toUtf8();
    said.text = text.constData();
    return QString::fromStdString(said.english());
}

std::vector<const char*> presetTexts() { return {std::begin(kPresetTexts), std::end(kPresetTexts)}; }

} // namespace vs::desktop
