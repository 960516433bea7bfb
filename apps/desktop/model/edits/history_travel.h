// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QTimer>

#include <optional>

namespace vs::desktop {

class DocumentHost;
class Editor;

// Goes to any state of the history, by undo and redo in short slices, so that the window answers meanwhile.
// Another edit made on the way ends the journey where it is.
class HistoryTravel : public QObject {
    Q_OBJECT

public:
    HistoryTravel(DocumentHost& host, Editor& editor);
    // Goes to the state in which so many of the steps hold.
    void goTo(std::size_t steps);
    [[nodiscard]] bool isUnderWay() const { return target_.has_value(); }

private:
    void advance();
    void stop();
    bool takeOne();

    DocumentHost& host_;
    Editor& editor_;
    QTimer timer_;
    std::optional<std::size_t> target_;
    std::size_t from_ = 0;
    std::size_t at_ = 0; // where the last slice left off
};

} // namespace vs::desktop
