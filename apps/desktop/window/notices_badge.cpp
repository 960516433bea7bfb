// SPDX-License-Identifier: Apache-2.0
#include "window/notices_badge.h"

#include "model/document/notices.h"
#include "parts/panel_parts.h"

namespace vs::desktop {

NoticesBadge::NoticesBadge(const Notices& notices, QWidget* parent) : QToolButton(parent), notices_(notices) {
    named(this, "noticesBadge", tr("Notices of reading"));
    setProperty("badge", true);
    setFocusPolicy(Qt::NoFocus);
    connect(&notices, &Notices::changed, this, &NoticesBadge::refresh);
    refresh();
}

void NoticesBadge::refresh() {
    setText(tr("Notices: %1").arg(notices_.unread()));
    setToolTip(notices_.all().join('\n') + '\n' +
               tr("Click to read what was unusual about the file (Ctrl+I)"));
    setVisible(notices_.unread() > 0);
}

} // namespace vs::desktop
