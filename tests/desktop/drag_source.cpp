// SPDX-License-Identifier: Apache-2.0
// A file manager for tests: a small window from which files are dragged as from a real one.
//   vs_drag_source X Y FILE...
// Says "ready", what the window under the drag answers ("welcome", "refused"), and how each drag ended:
// "copy", "move", "ignored".
#include <QAbstractNativeEventFilter>
#include <QDrag>
#include <QGuiApplication>
#include <QMimeData>
#include <QPainter>
#include <QRasterWindow>
#include <QUrl>

#include <xcb/xproto.h>

#include <iostream>
#include <utility>

namespace {

// While something is dragged, the only messages from another program are its answers to that.
class Answers : public QAbstractNativeEventFilter {
public:
    bool nativeEventFilter(const QByteArray&, void* message, qintptr*) override {
        constexpr unsigned kAccepts = 1;
        constexpr int kSentByAnother = 0x80;
        const auto& event = *static_cast<const xcb_client_message_event_t*>(message);
        if ((event.response_type & ~kSentByAnother) == XCB_CLIENT_MESSAGE) {
            const bool isWelcome = (event.data.data32[1] & kAccepts) != 0;
            std::cout << (isWelcome ? "welcome" : "refused") << std::endl;
        }
        return false;
    }
};

class Source : public QRasterWindow {
public:
    explicit Source(const QStringList& files) {
        for (const QString& file : files) {
            urls_.push_back(QUrl::fromLocalFile(file));
        }
    }

protected:
    void paintEvent(QPaintEvent*) override {
        QPainter(this).fillRect(QRect(QPoint(), size()), Qt::white);
        if (!std::exchange(isSeen_, true)) {
            std::cout << "ready" << std::endl;
        }
    }

    void mousePressEvent(QMouseEvent*) override {
        auto* drag = new QDrag(this);
        auto* data = new QMimeData;
        data->setUrls(urls_);
        drag->setMimeData(data);
        // As file managers do: moving is proposed, and what is moved goes from its place.
        const auto action = drag->exec(Qt::CopyAction | Qt::MoveAction, Qt::MoveAction);
        std::cout << (action == Qt::CopyAction   ? "copy"
                      : action == Qt::MoveAction ? "move"
                                                 : "ignored")
                  << std::endl;
    }

private:
    QList<QUrl> urls_;
    bool isSeen_ = false;
};

} // namespace

int main(int argc, char** argv) {
    QGuiApplication application(argc, argv);
    const QStringList arguments = QGuiApplication::arguments();
    if (arguments.size() < 4) {
        std::cerr << "usage: vs_drag_source X Y FILE...\n";
        return 2;
    }
    Source source(arguments.mid(3));
    source.setGeometry(arguments[1].toInt(), arguments[2].toInt(), 100, 60);
    Answers answers;
    application.installNativeEventFilter(&answers);
    source.show();
    return QGuiApplication::exec();
}
