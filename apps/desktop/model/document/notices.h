// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QStringList>

#include <string>
#include <vector>

namespace vs::desktop {

// What was unusual about the files of the open document and what was done about it: kept until another one is
// opened, and unread until a person has seen the list.
class Notices : public QObject {
    Q_OBJECT

public:
    [[nodiscard]] const QStringList& all() const { return all_; }
    [[nodiscard]] int unread() const { return unread_; }

    void add(const std::vector<std::string>& notices);
    void clear();
    void markRead();

signals:
    void changed();

private:
    QStringList all_;
    int unread_ = 0;
};

} // namespace vs::desktop
