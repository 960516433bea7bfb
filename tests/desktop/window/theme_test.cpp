// SPDX-License-Identifier: Apache-2.0
// Dark and light while a volume is open: the picture stays, text can be read, the keyboard can be seen.
#include "parts/theme.h"
#include "window_states.h"

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QImage>
#include <QLabel>
#include <QPalette>
#include <QToolButton>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace vs::desktop {
namespace {

// WCAG 2's relative luminance, and the contrast of two colours from 1 to 21.
double luminance(const QColor& colour) {
    const auto linear = [](double v) {
        return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) +
           0.0722 * linear(colour.blueF());
}

double contrast(const QColor& a, const QColor& b) {
    const auto [darker, lighter] = std::minmax({luminance(a), luminance(b)});
    return (lighter + 0.05) / (darker + 0.05);
}

constexpr double kReadable = 4.5; // WCAG 2, level AA

// The ground is the commonest colour, the text what stands out most from it.
double contrastIn(const QImage& image) {
    std::map<QRgb, int> counts;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            ++counts[image.pixel(x, y)];
        }
    }
    const auto ground = std::max_element(counts.begin(), counts.end(),
                                         [](const auto& a, const auto& b) { return a.second < b.second; });
    double most = 1;
    for (const auto& [colour, count] : counts) {
        most = std::max(most, contrast(QColor(colour), QColor(ground->first)));
    }
    return most;
}

class Themes : public testing::TestWithParam<const char*> {
protected:
    // As a person does it.
    void choose(const char* theme) {
        w.trigger("preferences");
        StudioWindow::wait("the preferences", [] { return QApplication::activeModalWidget() != nullptr; });
        QWidget* dialog = QApplication::activeModalWidget();
        dialog->findChild<QAbstractButton*>(theme)->click();
        dialog->close();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }
    void TearDown() override { choose("themeDark"); }
    QImage crop(const QImage& window, const QWidget& widget, int margin = 0) {
        const QRect place(widget.mapTo(&w.window(), QPoint(0, 0)), widget.size());
        return window.copy(place.adjusted(-margin, -margin, margin, margin).intersected(window.rect()));
    }

    StudioWindow& w = StudioWindow::instance();
};

TEST_P(Themes, LeaveThePictureAsItIs) {
    w.open();
    w.rest();
    const auto before = w.studio().picture().readPicture();
    choose(GetParam());
    w.rest();
    const auto after = w.studio().picture().readPicture();
    EXPECT_EQ(before.rgba, after.rgba);
}

TEST_P(Themes, HaveTextThatCanBeRead) {
    choose(GetParam());
    const QPalette palette = QApplication::palette();
    using P = QPalette;
    for (const auto& [text, ground] : {std::pair{P::WindowText, P::Window},
                                       {P::Text, P::Base},
                                       {P::ButtonText, P::Button},
                                       {P::PlaceholderText, P::Base},
                                       {P::ToolTipText, P::ToolTipBase},
                                       {P::HighlightedText, P::Highlight}}) {
        EXPECT_GE(contrast(palette.color(text), palette.color(ground)), kReadable)
            << text << " on " << ground;
    }
    std::map<std::string, double> faults;
    forEachState(w, [&](const std::string&, const QList<QWidget*>& widgets) {
        if (widgets.front()->window() != &w.window()) {
            return; // dialogs are made of the same parts
        }
        const QImage shown = w.window().grab().toImage();
        for (const QWidget* widget : widgets) {
            const auto* label = qobject_cast<const QLabel*>(widget);
            const auto* button = qobject_cast<const QAbstractButton*>(widget);
            const bool hasText = (label != nullptr && !label->text().trimmed().isEmpty()) ||
                                 (button != nullptr && !button->text().isEmpty());
            if (!hasText || !widget->isEnabled() ||
                widget->visibleRegion().boundingRect() != widget->rect()) {
                continue;
            }
            const double found = contrastIn(crop(shown, *widget));
            if (found < kReadable) {
                faults.emplace(described(*widget), found);
            }
        }
    });
    for (const auto& [fault, found] : faults) {
        ADD_FAILURE() << fault << " has a contrast of " << found;
    }
}

TEST_P(Themes, ShowWhatHasTheKeyboard) {
    choose(GetParam());
    w.open();
    w.trigger("drillTool");
    w.trigger("slices");
    w.settle();
    QApplication::setActiveWindow(&w.window());
    std::set<std::string> unseen;
    auto* elsewhere = &w.part("penPressure"); // that shows nothing of it
    elsewhere->setFocusPolicy(Qt::StrongFocus);
    for (QWidget* widget : w.window().findChildren<QWidget*>()) {
        const bool takesKeys =
            widget->isVisible() && widget->isEnabled() && (widget->focusPolicy() & Qt::TabFocus) != 0 &&
            widget->focusProxy() == nullptr && !widget->visibleRegion().isEmpty() && widget != elsewhere;
        if (!takesKeys) {
            continue;
        }
        const auto look = [&](QWidget* focused) {
            focused->setFocus(Qt::TabFocusReason);
            QCoreApplication::processEvents();
            constexpr int kAround = 40; // a slice's frame is around its header too
            const QRect place(widget->mapTo(&w.window(), QPoint(0, 0)), widget->size());
            return w.window().grab(place.adjusted(-kAround, -kAround, kAround, kAround)).toImage();
        };
        const QImage without = look(elsewhere);
        if (look(widget) == without) {
            unseen.insert(described(*widget));
        }
    }
    elsewhere->setFocusPolicy(Qt::NoFocus);
    w.trigger("only3D");
    for (const auto& name : unseen) {
        ADD_FAILURE() << name << " looks the same with the keyboard and without";
    }
}

INSTANTIATE_TEST_SUITE_P(, Themes, testing::Values("themeDark", "themeLight"),
                         [](const auto& theme) { return std::string(theme.param); });

} // namespace
} // namespace vs::desktop
