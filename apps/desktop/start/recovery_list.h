// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/keepers/recovery_keeper.h"

#include <QFrame>

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
    void recoverRequested(const vs::desktop::LostWork& lost);

private:
    QFrame* makeRow(const LostWork& lost, int number);
    void askToDiscard(const LostWork& lost);

    std::vector<QFrame*> rows_;
};

} // namespace vs::desktop
