// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/json/lost_work.h"

#include <QFrame>

#include <vector>

namespace vs::desktop {

// On the start screen: work that was lost with an earlier run, to be recovered or discarded. Hidden when
// there is none.
class RecoveryList : public QWidget {
    Q_OBJECT

public:
    explicit RecoveryList(QWidget* parent = nullptr);
    // Looks again.
    void refresh();

signals:
    void recoverRequested(const vs::studio::LostWork& lost);

private:
    QFrame* makeRow(const studio::LostWork& lost, int number);
    void askToDiscard(const studio::LostWork& lost);

    std::vector<QFrame*> rows_;
};

} // namespace vs::desktop
