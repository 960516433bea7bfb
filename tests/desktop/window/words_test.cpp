// SPDX-License-Identifier: Apache-2.0
// Messages, units and segments, as the window gives them.
#include "model/segments/growth_controller.h"
#include "model/segments/segment_controller.h"
#include "mouse.h"
#include "tools/seed_tool.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>

namespace vs::desktop {
namespace {

class Window : public testing::Test {
protected:
    void SetUp() override {
        w.open();
        w.studio().hand().setShape(studio::Shape::FreeForm);
        w.studio().growth().setAutoStart(false);
    }
    void TearDown() override { w.studio().growth().setAutoStart(true); }
    std::string message() { return w.studio().host().message().toStdString(); }
    void seed() {
        w.studio().hand().take(w.tools().get<SeedTool>());
        w.settle();
        mouse.drag({{0.45, 0.5}, {0.5, 0.51}, {0.55, 0.5}});
        w.settle();
    }
    const studio::Seed& lastSeed() {
        return std::get<studio::Seed>(w.studio().host().document()->log().back());
    }

    StudioWindow& w = StudioWindow::instance();
    Mouse mouse{w};
};

TEST_F(Window, SaysOnceWhatWasUndone) {
    seed();
    w.trigger("undo");
    EXPECT_EQ(message(), "Undone: seed");
    w.trigger("redo");
    EXPECT_EQ(message(), "Redone: seed");
    w.trigger("scissorsTool");
    w.settle();
    for (int n = 0; n < 2; ++n) { // the second time there is nothing left
        mouse.drag({{0.45, 0.45}, {0.55, 0.45}, {0.55, 0.55}, {0.45, 0.55}});
        w.settle();
    }
    EXPECT_EQ(message(), "Nothing was cut: nothing visible lies there that was not cut already");
}

TEST(Texts, EveryRadiusAndDepthHasItsUnit) {
    auto& w = StudioWindow::instance();
    w.open();
    int found = 0;
    for (const char* tool : {"peelTool", "drillTool", "laserTool", "sweepTool", "scissorsTool", "clipTool"}) {
        w.trigger(tool);
        for (const QLabel* label : w.window().findChildren<QLabel*>()) {
            const bool isLength = label->text().startsWith("Radius") || label->text().startsWith("Depth") ||
                                  label->text().startsWith("Tiefe");
            if (label->isVisible() && isLength) {
                ++found;
                EXPECT_TRUE(label->text().endsWith("(steps)") || label->text().endsWith("(Schritte)"))
                    << label->text().toStdString() << " of " << tool;
            }
        }
    }
    EXPECT_GE(found, 8);
}

TEST_F(Window, AddsASecondSegmentBesideTheFirst) {
    auto& segments = w.studio().segments();
    segments.add();
    ASSERT_EQ(segments.list().segments.size(), 2U);
    EXPECT_EQ(segments.list().segments.front().name, "Segment 1");
    EXPECT_EQ(segments.list().working().label, 2);
    EXPECT_EQ(std::get<studio::UseSegment>(w.studio().host().document()->log().back()).takesFirst, false);
}

TEST_F(Window, ANewSegmentGrowsInTheRangeThatIsSet) {
    auto& growth = w.studio().growth();
    growth.setTakesDisplayedRange(false);
    studio::SetGrowthRules rules;
    rules.range = Range{110, 130};
    growth.changeRules(rules, false);
    growth.releaseRules();
    w.settle();
    seed();
    w.studio().segments().add();
    w.studio().view().setRange({150, 200}); // the display moves on
    w.settle();
    EXPECT_EQ(growth.range(), (Range{110, 130}));
    EXPECT_EQ(w.part<QDoubleSpinBox>("growthLo").value(), 110);
    EXPECT_EQ(w.part<QDoubleSpinBox>("growthHi").value(), 130);
    w.studio().view().setRange({100, 200});
    w.settle();
    mouse.drag({{0.45, 0.56}, {0.5, 0.57}, {0.55, 0.56}});
    w.settle();
    EXPECT_EQ(lastSeed().range, (Range{110, 130}));
    // With strokes that bring it, it is the displayed one.
    growth.setTakesDisplayedRange(true);
    w.studio().segments().add();
    w.settle();
    EXPECT_EQ(growth.range(), (Range{100, 200}));
}

TEST_F(Window, ALongNoteIsReadInItsTip) {
    const std::string text =
        "the margin to the vessel is kept at 5 mm < 1 cm, as the second reader asked for";
    ASSERT_TRUE(w.studio().editor().apply(studio::Note{text}));
    auto& history = w.part("historyPanel");
    const bool wasHidden = history.isHidden();
    history.show();
    w.settle();
    auto& list = w.part<QListWidget>("historyList");
    ASSERT_GE(list.count(), 2);
    const QString tip = list.item(list.count() - 1)->toolTip();
    EXPECT_TRUE(tip.contains(QString::fromStdString(text).toHtmlEscaped())) << tip.toStdString();
    history.setHidden(wasHidden);
}

TEST_F(Window, TheLineForANoteShowsSixtyCharacters) {
    w.trigger("addNote");
    auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
    ASSERT_NE(dialog, nullptr);
    ASSERT_EQ(dialog->objectName(), "note");
    const auto* line = dialog->findChild<QLineEdit*>();
    EXPECT_GE(line->width(), 60 * line->fontMetrics().averageCharWidth());
    dialog->reject();
}

} // namespace
} // namespace vs::desktop
