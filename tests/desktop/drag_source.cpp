// SPDX-License-Identifier: Apache-2.0
// A file manager for tests: a small window from which files are dragged as from a real one.
//   vs_drag_source X Y FILE...
// Says "ready", and how each drag ended: "copy", "move", "ignored".
#include <QDrag>
#include <QGuiApplication>
#include <QMimeData>
#include <QPainter>
#include <QRasterWindow>
#include <QUrl>

#include <iostream>

namespace {

class Source : public QRasterWindow {
public:
    explicit Source(const QStringList& files) {
        for (const QString& file : files) {
            urls_.push_back(QUrl::fromLocalFile(file));
        }
    }

protected:
    void paintEvent(QPaintEvent*) override { QPainter(this).fillRect(QRect(QPoint(), size()), Qt::white); }

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
    source.show();
    std::cout << "ready" << std::endl;
    return QGuiApplication::exec();
}
