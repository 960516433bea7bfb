// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/keepers/recent_documents.h"

#include <QTimer>
#include <QWidget>

class QLabel;
class QVBoxLayout;

namespace vs::studio {
struct LostWork;
}

namespace vs::desktop {

class CardGrid;
class RecoveryList;
class SlicePictures;

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
    void blockRequested();
    void recoverRequested(const vs::studio::LostWork& lost);
    void documentChosen(const vs::desktop::OpenRequest& request);

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    struct Section {
        QLabel* title = nullptr;
        CardGrid* cards = nullptr;
    };

    void makePictures();
    void addHead(QVBoxLayout* column);
    Section addSection(QVBoxLayout* column, const QString& title);
    void fill(Section& section, const std::vector<KnownDocument>& documents, const QString& name,
              bool canForget);

    SlicePictures* pictures_;
    QTimer calm_;            // the start screen has been looked at for a moment
    QLabel* mark_ = nullptr; // the program's own
    RecoveryList* recovery_ = nullptr;
    Section recent_;
    Section examples_;
    Section cases_;
};

} // namespace vs::desktop
