// SPDX-License-Identifier: Apache-2.0
#include "model/texts/library_texts.h"

#include <QCoreApplication>
#include <QRegularExpression>

namespace vs::desktop {

namespace {

constexpr const char* kTexts[] = {
    // operations
    QT_TRANSLATE_NOOP("library", "view"), QT_TRANSLATE_NOOP("library", "peel"),
    QT_TRANSLATE_NOOP("library", "drill"), QT_TRANSLATE_NOOP("library", "laser"),
    QT_TRANSLATE_NOOP("library", "sweep"), QT_TRANSLATE_NOOP("library", "scissors"),
    QT_TRANSLATE_NOOP("library", "clip"), QT_TRANSLATE_NOOP("library", "keep connected"),
    QT_TRANSLATE_NOOP("library", "paste"), QT_TRANSLATE_NOOP("library", "move part"),
    QT_TRANSLATE_NOOP("library", "seed"), QT_TRANSLATE_NOOP("library", "grow"),
    QT_TRANSLATE_NOOP("library", "rewind"), QT_TRANSLATE_NOOP("library", "show generation"),
    QT_TRANSLATE_NOOP("library", "growth rules"), QT_TRANSLATE_NOOP("library", "absorb"),
    QT_TRANSLATE_NOOP("library", "segment"), QT_TRANSLATE_NOOP("library", "load labels"),
    QT_TRANSLATE_NOOP("library", "remove segment"), QT_TRANSLATE_NOOP("library", "edit segment"),
    QT_TRANSLATE_NOOP("library", "brush segment"), QT_TRANSLATE_NOOP("library", "paint segment"),
    QT_TRANSLATE_NOOP("library", "cut segment"), QT_TRANSLATE_NOOP("library", "undo"),
    QT_TRANSLATE_NOOP("library", "redo"), QT_TRANSLATE_NOOP("library", "un-cut"),
    QT_TRANSLATE_NOOP("library", "re-seed"), QT_TRANSLATE_NOOP("library", "picture"),
    QT_TRANSLATE_NOOP("library", "labels"), QT_TRANSLATE_NOOP("library", "sculpture"),
    // edits of segments
    QT_TRANSLATE_NOOP("library", "keep island"), QT_TRANSLATE_NOOP("library", "drop island"),
    QT_TRANSLATE_NOOP("library", "keep largest"), QT_TRANSLATE_NOOP("library", "drop small"),
    QT_TRANSLATE_NOOP("library", "fill holes"), QT_TRANSLATE_NOOP("library", "margin"),
    QT_TRANSLATE_NOOP("library", "open"), QT_TRANSLATE_NOOP("library", "close"),
    QT_TRANSLATE_NOOP("library", "smooth"), QT_TRANSLATE_NOOP("library", "hollow"),
    QT_TRANSLATE_NOOP("library", "unite"), QT_TRANSLATE_NOOP("library", "subtract"),
    QT_TRANSLATE_NOOP("library", "intersect"),
    // what was done
    QT_TRANSLATE_NOOP("library", "%1 voxels changed"), QT_TRANSLATE_NOOP("library", "%1 voxels added"),
    QT_TRANSLATE_NOOP("library", "%1 voxels removed"), QT_TRANSLATE_NOOP("library", "%1 voxels seeded"),
    QT_TRANSLATE_NOOP(
        "library",
        "%1 voxels seeded, %2 refused (outside the grid or the range, cut away, or another segment's)"),
    QT_TRANSLATE_NOOP("library", "%1 voxels absorbed in %2 expansions"),
    QT_TRANSLATE_NOOP("library", "%1 voxels, %2 ml; %3 before"),
    QT_TRANSLATE_NOOP("library", "%1 generation; %2 voxels, %3 ml"),
    QT_TRANSLATE_NOOP("library", "%1 generations; %2 voxels, %3 ml"),
    QT_TRANSLATE_NOOP("library", "%1 generation back; %2 voxels, %3 ml"),
    QT_TRANSLATE_NOOP("library", "%1 generations back; %2 voxels, %3 ml"),
    QT_TRANSLATE_NOOP("library", "growing in %1 to %2; %3 voxels"), QT_TRANSLATE_NOOP("library", "part %1"),
    QT_TRANSLATE_NOOP("library", "%1 segment, %2 voxels"),
    QT_TRANSLATE_NOOP("library", "%1 segments, %2 voxels"), QT_TRANSLATE_NOOP("library", "at work on %1"),
    QT_TRANSLATE_NOOP("library", "%1 changed"), QT_TRANSLATE_NOOP("library", "all cuts cleared"),
    QT_TRANSLATE_NOOP("library", "segmentation cleared"),
    QT_TRANSLATE_NOOP("library", "nothing was cut: nothing visible lies there that was not cut already"),
    QT_TRANSLATE_NOOP("library", "nothing was restored: nothing was cut away there"),
    QT_TRANSLATE_NOOP("library", "nothing seeded: no voxel in range lies under the stroke"),
    QT_TRANSLATE_NOOP("library", "nothing absorbed: the stroke does not lie on the segment"),
    QT_TRANSLATE_NOOP("library", "nothing changed: no voxel lies under the brush"),
    QT_TRANSLATE_NOOP("library", "nothing changed: no voxel under the brush could be added or removed"),
    QT_TRANSLATE_NOOP("library", "nothing changed: the stroke does not reach the segment's surface"),
    // transfer functions
    QT_TRANSLATE_NOOP("library", "CT bone"), QT_TRANSLATE_NOOP("library", "Skeleton alone; Hounsfield units"),
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
                      "Every value, evenly: grey and opacity rise together; follows the histogram"),
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
        "Head from T1-weighted MR, nearly opaque: a cut shows grey and white matter; follows the histogram"),
    // colour tables
    QT_TRANSLATE_NOOP("library", "grey"), QT_TRANSLATE_NOOP("library", "black to white"),
    QT_TRANSLATE_NOOP("library", "ivory"), QT_TRANSLATE_NOOP("library", "bone: umber shadows to ivory"),
    QT_TRANSLATE_NOOP("library", "ember"), QT_TRANSLATE_NOOP("library", "night, embers, flame"),
    QT_TRANSLATE_NOOP("library", "marine"), QT_TRANSLATE_NOOP("library", "deep sea to foam"),
    QT_TRANSLATE_NOOP("library", "flesh"), QT_TRANSLATE_NOOP("library", "muscle to pale skin"),
    QT_TRANSLATE_NOOP("library", "vessel"), QT_TRANSLATE_NOOP("library", "dark blood to bright blood"),
    QT_TRANSLATE_NOOP("library", "tide"),
    QT_TRANSLATE_NOOP("library", "blue below, orange above, pale in the middle"),
    // examples
    QT_TRANSLATE_NOOP("library", "A head, magnetic resonance"),
    QT_TRANSLATE_NOOP("library", "The same head, sharper"), QT_TRANSLATE_NOOP("library", "Its brain alone"),
    QT_TRANSLATE_NOOP("library", "A macaque's brain")};

QString translated(const QString& text) {
    return QCoreApplication::translate("library", text.toUtf8().constData());
}

} // namespace

QString libraryText(std::string_view english) {
    const QString text = QString::fromUtf8(english.data(), qsizetype(english.size()));
    const QString whole = translated(text);
    if (whole != text) {
        return whole;
    }
    // Numbers and quoted names out, and in again where the translation has their places.
    static const QRegularExpression varying(R"('[^']*'|-?\d+(\.\d+)?(e[-+]?\d+)?)");
    QString pattern;
    QStringList values;
    qsizetype from = 0;
    for (auto it = varying.globalMatch(text); it.hasNext();) {
        const auto match = it.next();
        values << match.captured();
        pattern += text.mid(from, match.capturedStart() - from) + "%" + QString::number(values.size());
        from = match.capturedEnd();
    }
    pattern += text.mid(from);
    QString result = translated(pattern);
    if (result == pattern) {
        return text;
    }
    for (const QString& value : values) {
        result = result.arg(value);
    }
    return result;
}

std::vector<const char*> knownLibraryTexts() { return {std::begin(kTexts), std::end(kTexts)}; }

} // namespace vs::desktop
