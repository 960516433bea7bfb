// SPDX-License-Identifier: Apache-2.0
#include "dialogs/properties_dialog.h"

#include "dialogs/geometry_card.h"
#include "model/studio/studio_controller.h"
#include "parts/panel_parts.h"

#include <QApplication>
#include <QClipboard>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

namespace vs::desktop {

namespace {

QLabel* makeSelectable(const QString& text) {
    auto* label = new QLabel(text);
    label->setTextFormat(Qt::PlainText); // whatever files say
    label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    label->setWordWrap(true);
    return label;
}

QString asText(const std::vector<Property>& properties, const QStringList& notices) {
    QStringList lines;
    for (const Property& property : properties) {
        lines << property.name + ": " + property.text;
    }
    return (lines + notices).join('\n');
}

} // namespace

PropertiesDialog::PropertiesDialog(StudioController& studio, QWidget* parent)
    : QDialog(parent), studio_(studio) {
    setObjectName("propertiesDialog");
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Properties of the volume"));
    auto* page = new QWidget;
    auto* content = new QVBoxLayout(page);
    content->setContentsMargins(20, 18, 20, 10);
    content->setSpacing(16);
    tablePlace_ = new QVBoxLayout;
    content->addLayout(tablePlace_);
    showTable();
    content->addWidget(new GeometryCard(studio));
    content->addWidget(makeNotices(studio.notices().all()));
    content->addStretch(1);
    auto* scroll = new QScrollArea; // small screens, many notices
    scroll->setWidget(page);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setFocusPolicy(Qt::NoFocus);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 14);
    column->addWidget(scroll, 1);
    column->addWidget(makeButtons());
    const QSize wanted(660, 900);
    resize(parent != nullptr ? wanted.boundedTo(parent->size()) : wanted);
    connect(&studio.host(), &DocumentHost::corrected, this, &PropertiesDialog::showTable);
    connect(&studio.host(), &DocumentHost::leaving, this, &QDialog::close);
}

std::vector<Property> PropertiesDialog::properties() {
    return propertiesOf(*studio_.host().volume(), *studio_.host().geometry(),
                        *studio_.host().geometryInFile());
}

// Instead of the one that was shown before.
void PropertiesDialog::showTable() {
    if (const QLayoutItem* before = tablePlace_->takeAt(0)) {
        before->widget()->deleteLater();
        before->widget()->hide();
        delete before;
    }
    tablePlace_->addWidget(makeTable(properties()));
}

QWidget* PropertiesDialog::makeTable(const std::vector<Property>& properties) {
    auto* table = new QWidget;
    auto* form = makeForm(table);
    form->setVerticalSpacing(7);
    form->setHorizontalSpacing(18);
    for (const Property& property : properties) {
        auto* value = named(makeSelectable(property.text), "", property.name);
        value->setObjectName(QString("property.") + property.key);
        value->setProperty("report", property.text);
        form->addRow(makeQuietLabel(property.name), value);
    }
    return table;
}

QWidget* PropertiesDialog::makeNotices(const QStringList& notices) {
    QVBoxLayout* content = nullptr;
    auto* card = makeCard(tr("Notices of reading"), content);
    for (const QString& notice : notices) {
        content->addWidget(named(makeSelectable(notice), "notice", tr("Notice")));
    }
    if (notices.isEmpty()) {
        content->addWidget(makeQuietLabel(tr("There are none: the file was read as it is.")));
    }
    return card;
}

QWidget* PropertiesDialog::makeButtons() {
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    buttons->setContentsMargins(20, 0, 20, 0);
    buttons->button(QDialogButtonBox::Close)->setObjectName("closeProperties");
    buttons->button(QDialogButtonBox::Close)->setDefault(true);
    auto* copy = buttons->addButton(tr("Copy"), QDialogButtonBox::ActionRole);
    copy->setObjectName("copyProperties");
    copy->setToolTip(tr("Copy all of it as text"));
    connect(copy, &QPushButton::clicked, this,
            [this] { QApplication::clipboard()->setText(asText(properties(), studio_.notices().all())); });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    return buttons;
}

} // namespace vs::desktop
