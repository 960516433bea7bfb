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

#include <xcb/xcb.h>

#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <string_view>
#include <utility>

namespace {

// Sees the window's answers to a drag (XdndStatus of the XDND protocol): one to each place that it was asked
// about. Qt sends this program other messages too, whose words mean something else.
class Answers : public QAbstractNativeEventFilter {
public:
    explicit Answers(xcb_connection_t* connection) : status_(atom(connection, "XdndStatus")) {}

    bool nativeEventFilter(const QByteArray&, void* message, qintptr*) override {
        constexpr unsigned kAccepts = 1;
        constexpr int kSentByAnother = 0x80;
        const auto& event = *static_cast<const xcb_client_message_event_t*>(message);
        if ((event.response_type & ~kSentByAnother) == XCB_CLIENT_MESSAGE && event.type == status_) {
            const bool isWelcome = (event.data.data32[1] & kAccepts) != 0;
            std::cout << (isWelcome ? "welcome" : "refused") << std::endl;
        }
        return false;
    }

private:
    static xcb_atom_t atom(xcb_connection_t* connection, std::string_view name) {
        const auto asked = xcb_intern_atom(connection, 0, std::uint16_t(name.size()), name.data());
        const std::unique_ptr<xcb_intern_atom_reply_t, decltype(&std::free)> reply(
            xcb_intern_atom_reply(connection, asked, nullptr), &std::free);
        return reply ? reply->atom : xcb_atom_t(XCB_ATOM_NONE);
    }

    xcb_atom_t status_;
};

class Source : public QRasterWindow {
public:
    explicit Source(const QStringList& files) {
        // Otherwise a press on it takes the keyboard from the window under test, whose Qt takes note of that
        // only 100 ms later: a button that is held down there at that moment is let go, without its click.
        setFlag(Qt::WindowDoesNotAcceptFocus);
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
        data->setText(urls_.front().toString()); // GTK's file managers offer text too
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
    const auto* x11 = application.nativeInterface<QNativeInterface::QX11Application>();
    if (x11 == nullptr) {
        std::cerr << "vs_drag_source drags on an X server only\n";
        return 2;
    }
    Answers answers(x11->connection());
    application.installNativeEventFilter(&answers);
    source.show();
    return QGuiApplication::exec();
}
