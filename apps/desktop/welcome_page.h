// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "recent_documents.h"

#include <QWidget>

class QLabel;
class QVBoxLayout;

namespace vs::desktop {

class CardGrid;

// The start screen: what was open of late, examples, and the ways to open something else.
class WelcomePage : public QWidget {
    Q_OBJECT

public:
    explicit WelcomePage(QWidget* parent = nullptr);
    // Looks again at what there is to open.
    void refresh();

signals:
    void openRequested();
    void openFolderRequested();
    void documentChosen(const vs::desktop::OpenRequest& request);

protected:
    void showEvent(QShowEvent* event) override;

private:
    struct Section {
        QLabel* title = nullptr;
        CardGrid* cards = nullptr;
    };

    void addHead(QVBoxLayout* column);
    Section addSection(QVBoxLayout* column, const QString& title);
    void fill(Section& section, const std::vector<KnownDocument>& documents, const QString& name,
              bool canForget);

    Section recent_;
    Section examples_;
};

} // namespace vs::desktop
