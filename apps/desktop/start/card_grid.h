// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

#include <vector>

namespace vs::desktop {

class StartCard;

// Cards in rows, as many in each as there is room for. Arrow keys go from card to card.
class CardGrid : public QWidget {
    Q_OBJECT

public:
    static constexpr int kGap = 14;

    using QWidget::QWidget;
    // Takes the place of those that were there, which are deleted.
    void setCards(const std::vector<StartCard*>& cards);

protected:
    void resizeEvent(QResizeEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    [[nodiscard]] int columns() const;
    void place();

    std::vector<StartCard*> cards_;
};

} // namespace vs::desktop
