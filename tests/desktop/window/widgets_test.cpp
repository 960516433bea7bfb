// SPDX-License-Identifier: Apache-2.0
// What every widget owes to those who do not see or do not point: a name, a tip, the keyboard; and room for
// its text, in every language.
#include "model/texts/language.h"
#include "model/texts/library_texts.h"
#include "window_states.h"

#include "render/colours/colour_map.h"
#include "render/colours/transfer_function_json.h"
#include "studio/operations/operation.h"

#include <gtest/gtest.h>

#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QAccessible>
#include <QAction>
#include <QButtonGroup>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenuBar>
#include <QPushButton>
#include <QScrollBar>
#include <QTextDocument>
#include <QToolButton>

#include <algorithm>
#include <map>
#include <set>

namespace vs::desktop {
namespace {

template <class... Kinds>
bool isOneOf(const QWidget* widget) {
    return ((qobject_cast<const Kinds*>(widget) != nullptr) || ...);
}

bool isInteractive(const QWidget* widget) {
    const QWidget* parent = widget->parentWidget();
    const bool isPartOfOther = qobject_cast<const QScrollBar*>(widget) != nullptr ||
                               isOneOf<QAbstractSpinBox, QComboBox, QAbstractItemView, QMenuBar>(parent) ||
                               (parent != nullptr && isOneOf<QAbstractItemView>(parent->parentWidget()));
    return widget->isEnabled() && !isPartOfOther &&
           isOneOf<QAbstractButton, QAbstractSlider, QAbstractSpinBox, QComboBox, QLineEdit,
                   QAbstractItemView>(widget);
}

TEST(Widgets, HaveANameATipAndTheKeyboard) {
    std::map<std::string, std::string> faults; // and where they were first seen
    forEachState(StudioWindow::instance(), [&](const std::string& state, const QList<QWidget*>& widgets) {
        for (const QWidget* widget : widgets) {
            if (!isInteractive(widget)) {
                continue;
            }
            const auto* button = qobject_cast<const QAbstractButton*>(widget);
            auto* accessible = QAccessible::queryAccessibleInterface(const_cast<QWidget*>(widget));
            const auto complain = [&](const char* what) {
                faults.emplace(described(*widget) + " " + what, state);
            };
            if (accessible == nullptr || accessible->text(QAccessible::Name).isEmpty()) {
                complain("has no accessible name");
                continue;
            }
            const QString name = accessible->text(QAccessible::Name).remove("…");
            const bool saysAll = isOneOf<QAbstractItemView>(widget) ||
                                 (button != nullptr && button->text().remove('&').remove("…") == name);
            if (widget->toolTip().isEmpty() && !saysAll) {
                complain("has no tip");
            }
            // Of choices that exclude one another Tab reaches the one that is chosen, arrow keys the others.
            const bool isChoice =
                button != nullptr && button->group() != nullptr && button->group()->exclusive();
            if ((widget->focusPolicy() & Qt::TabFocus) == 0 && !isChoice) {
                complain("cannot be reached by Tab");
            }
        }
    });
    for (const auto& [fault, state] : faults) {
        ADD_FAILURE() << fault << " (" << state << ")";
    }
}

TEST(Actions, HaveTheirKeysForThemselves) {
    std::map<QString, QString> owners;
    for (const auto* action : StudioWindow::instance().window().findChildren<QAction*>()) {
        for (const QKeySequence& keys : action->shortcuts()) {
            const auto [owner, isFirst] = owners.emplace(keys.toString(), action->objectName());
            EXPECT_TRUE(isFirst) << qPrintable(keys.toString() + " means " + owner->second + " and " +
                                               action->objectName());
        }
    }
    EXPECT_FALSE(owners.empty());
}

// Room that the text lacks, in logical pixels; 0: it fits.
int lacking(const QWidget& widget) {
    if (const auto* label = qobject_cast<const QLabel*>(&widget)) {
        if (label->wordWrap()) {
            return std::max(0, label->heightForWidth(label->width()) - label->height());
        }
        return label->text().isEmpty() ? 0 : std::max(0, label->sizeHint().width() - label->width());
    }
    if (const auto* bar = qobject_cast<const QScrollBar*>(&widget)) {
        return bar->orientation() == Qt::Horizontal ? bar->maximum() : 0; // what lies beside the edge
    }
    if (isOneOf<QPushButton, QComboBox>(&widget)) {
        return std::max(0, widget.minimumSizeHint().width() - widget.width());
    }
    if (const auto* button = qobject_cast<const QToolButton*>(&widget)) {
        const bool hasText = button->toolButtonStyle() != Qt::ToolButtonIconOnly && !button->text().isEmpty();
        return hasText ? std::max(0, button->sizeHint().width() - button->width()) : 0;
    }
    return 0;
}

TEST(Texts, FitTheirPlaces) {
    std::map<std::string, std::string> faults; // and where they were first seen
    int n = 0;
    forEachState(StudioWindow::instance(), [&](const std::string& state, const QList<QWidget*>& widgets) {
        StudioWindow::instance().photograph(*widgets.front()->window(),
                                            QString("state_%1_%2")
                                                .arg(n++, 2, 10, QChar('0'))
                                                .arg(QString::fromStdString(state))
                                                .toStdString());
        // What follows the pen and what was done gives way, as does the name of a person's own colours.
        static const std::set<QString> gives{"message", "probe", "functionChoice"};
        for (const QWidget* widget : widgets) {
            const int pixels = gives.count(widget->objectName()) > 0 ? 0 : lacking(*widget);
            if (pixels > 1) {
                faults.emplace(described(*widget) + " lacks room",
                               std::to_string(pixels) + " pixels, in " + state);
            }
        }
    });
    for (const auto& [fault, state] : faults) {
        ADD_FAILURE() << fault << " (" << state << ")";
    }
}

TEST(Texts, AreKnownForWhatTheLibraryNames) {
    std::set<std::string> known;
    for (const char* text : presetTexts()) {
        known.insert(text);
    }
    for (const std::string& name : render::presetNames()) {
        EXPECT_TRUE(known.contains(render::findPreset(name)->name)) << name;
        EXPECT_TRUE(known.contains(render::findPreset(name)->description)) << name;
    }
}

TEST(Texts, OfWhatTheLibraryNamesAreInTheLanguageSpoken) {
    const bool isGerman = textLocale().language() == QLocale::German;
    std::vector<std::string> texts;
    for (const char* name : studio::operationNames()) {
        texts.emplace_back(name);
    }
    for (const char* name : studio::EditSegment::kKinds) {
        texts.emplace_back(name);
    }
    for (const auto& map : render::colourMaps()) {
        texts.emplace_back(map.name);
        texts.emplace_back(map.description);
    }
    for (const std::string& text : texts) {
        EXPECT_EQ(libraryText(text).toStdString() != text, isGerman) << text;
    }
}

TEST(Texts, KeepTheirNumbers) {
    const Phrase phrase = say(VS_TEXT("library", "%1 generations; %2 voxels, %3 ml"), 3, 120, "0.4");
    EXPECT_EQ(phrase.english(), "3 generations; 120 voxels, 0.4 ml");
    const QString said = libraryText(phrase);
    for (const char* number : {"3", "120", "0.4"}) {
        EXPECT_TRUE(said.contains(number)) << said.toStdString();
    }
    const bool isGerman = textLocale().language() == QLocale::German;
    EXPECT_EQ(said.contains("Generationen"), isGerman) << said.toStdString();
    EXPECT_EQ(libraryText("the disk is full"), "the disk is full") << "errors stay as they are";
}

} // namespace
} // namespace vs::desktop
