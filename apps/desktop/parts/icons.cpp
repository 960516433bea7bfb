// SPDX-License-Identifier: Apache-2.0
#include "parts/icons.h"

#include "parts/theme.h"

#include "base/check.h"

#include <QIconEngine>
#include <QPainter>
#include <QPixmap>
#include <QSvgRenderer>

#include <map>
#include <string>

namespace vs::desktop {

namespace {

// Content of a 24 x 24 SVG drawn with a line 1.7 wide; "C" as a colour is replaced by the icon's accent.
const std::map<std::string, const char*>
    kShapes{
        {"open", R"(<path d="M3 19V6h6l2 2.5h10V19z"/>)"},
        {"folder", R"(<path d="M3 19V6h6l2 2.5h10V19z"/><path d="M7 12h10M7 15.5h10"/>)"},
        {"session",
         R"(<path d="M6 3h9l4 4v14H6z"/><path d="M15 3v4h4"/><path stroke="C" d="M10 11.5l5 3-5 3z"/>)"},
        {"save",
         R"(<path d="M4 4h12.5L20 7.500V20H4z"/><path d="M8 4v5h7V4"/><path d="M7.500 20v-6.500h9V20"/>)"},
        {"labels",
         R"(<path d="M12 3l9 5-9 5-9-5z"/><path stroke="C" d="M3 12l9 5 9-5"/><path d="M3 16l9 5 9-5"/>)"},
        {"screenshot",
         R"(<path d="M3 7.500h4.500L9 5h6l1.500 2.500H21V19H3z"/><circle cx="12" cy="13" r="3.600"/>)"},
        {"add", R"(<path stroke="C" d="M12 5v14M5 12h14"/>)"},
        {"remove",
         R"(<path d="M5 7h14M9.500 7V4.500h5V7M6.500 7l1 13h9l1-13"/><path stroke="C" d="M10.500 11v5.500M13.500 11v5.500"/>)"},
        {"quit", R"(<path d="M10 4H4v16h6"/><path d="M9 12h11M16 8l4 4-4 4"/>)"},
        {"reset", R"(<path d="M4 11.500L12 4l8 7.500"/><path d="M6 10v10h12V10"/>)"},
        {"surface",
         R"(<circle cx="12" cy="12" r="8.500"/><path stroke="C" d="M7.500 10a5.500 5.500 0 0 1 4-3.500"/>)"},
        {"mip", R"(<path d="M3 19l5-7 3 3 4-9 6 13z"/><path stroke="C" d="M12 5.500h6"/>)"},
        {"xray",
         R"(<path d="M12 4v16"/><path stroke="C" d="M12 8c-4 0-6 1-7 3M12 12c-4 0-6 1-7 3M12 8c4 0 6 1 7 3M12 12c4 0 6 1 7 3"/>)"},
        {"overlay",
         R"(<circle cx="12" cy="12" r="8.500" stroke-dasharray="2.500 2.500"/><circle cx="12" cy="12" r="4" stroke="C" fill="C"/>)"},
        {"segment",
         R"(<circle cx="12" cy="12" r="8.500"/><path stroke="C" fill="C" d="M12 12V3.500A8.500 8.500 0 0 1 20.500 12z"/>)"},
        {"volume",
         R"(<path d="M12 3l8 4.500v9L12 21l-8-4.500v-9z"/><path stroke="C" d="M4 7.500l8 4.500 8-4.500M12 12v9"/>)"},
        {"cut", R"(<path d="M12 20.500a8.500 8.500 0 1 1 8.500-8.500H12z"/>)"},
        {"probe",
         R"(<path d="M12 20.500a8.500 8.500 0 1 1 8.500-8.500" stroke-dasharray="1.500 3"/><path stroke="C" d="M12 12h8.500a8.500 8.500 0 0 1-8.500 8.500z"/>)"},
        {"whole", R"(<circle cx="12" cy="12" r="8.500"/>)"},
        {"camera",
         R"(<path d="M19.500 9A8 8 0 0 0 5 8.500M4.500 15A8 8 0 0 0 19 15.500"/><path d="M19.800 4.500V9h-4.500M4.200 19.500V15h4.500"/>)"},
        {"peel",
         R"(<path d="M4 17c4-7 12-7 16 0"/><path stroke="C" d="M6 11c3-5 9-5 12 0"/><path stroke="C" d="M12 3v5M9.800 6L12 8.200 14.200 6"/>)"},
        {"drill",
         R"(<path d="M8 3h8v5H8z"/><path d="M9.500 8h5v4h-5z"/><path stroke="C" d="M10.500 12h3L12 21z"/>)"},
        {"laser",
         R"(<path d="M3.500 17.500c4-3.500 13-3.500 17 0"/><path stroke="C" d="M15.500 3.500L11 14"/><path d="M14 3l3.500 1.500"/><path stroke="C" d="M8 10.500l1.500 1.500M14.500 14l-1-1.500M6.500 13.500l2 .500"/>)"},
        {"sweep",
         R"(<path d="M4.500 19.500C4.500 9 12 14 12 8.500" stroke-dasharray="2 2.600"/><ellipse cx="15.500" cy="6" rx="5" ry="3" stroke="C"/><ellipse cx="5.500" cy="18.500" rx="3" ry="2"/>)"},
        {"scissors",
         R"(<circle cx="6.500" cy="17.500" r="2.800"/><circle cx="17.500" cy="17.500" r="2.800"/><path d="M8 15L16.500 3.500M16 15L7.500 3.500"/><circle cx="12" cy="9.700" r=".500" stroke="C"/>)"},
        {"keep",
         R"(<circle cx="10.500" cy="9.500" r="6" stroke="C" fill="C" fill-opacity=".350"/><path d="M7.800 9.500l2 2 3.600-3.800"/><path d="M3.500 20.500h17" stroke-dasharray="1.500 3"/>)"},
        {"clip",
         R"(<path d="M6.500 2.500v15h15"/><path d="M2.500 6.500h15v15"/><path stroke="C" d="M9.500 14.500l5-5M9.500 10.500l1-1M13.500 14.500l1-1"/>)"},
        {"move",
         R"(<path d="M12 3v18M3 12h18"/><path d="M9.500 5.500L12 3l2.500 2.500M9.500 18.500L12 21l2.500-2.500M5.500 9.500L3 12l2.500 2.500M18.500 9.500L21 12l-2.500 2.500"/><circle cx="12" cy="12" r="2.500" stroke="C" fill="C"/>)"},
        {"paste",
         R"(<path d="M11.500 20H4.500V5h3"/><path d="M12.500 5h3v4"/><path d="M7.500 3.500h5v3h-5z"/><path stroke="C" d="M11 10.500h9v10h-9zM13.500 14h4M13.500 17h4"/>)"},
        {"restore",
         R"(<path d="M12 20.500a8.500 8.500 0 1 1 8.500-8.500"/><path stroke="C" fill="C" fill-opacity=".350" d="M12 12h8.500a8.500 8.500 0 0 1-8.500 8.500z"/><path stroke="C" d="M21 2.500l-6 6M15 4.500v4h4"/>)"},
        {"seed",
         R"(<path d="M12 21v-9"/><path stroke="C" d="M12 12c0-5 3.500-7.500 8-7.500 0 5-3 7.500-8 7.500zM12 15c0-4-2.500-6-7-6 0 4 2.500 6 7 6z"/>)"},
        {"slices",
         R"(<path d="M3.500 3.500h17v17h-17z"/><path d="M12 3.500v17M3.500 12h17"/><path stroke="C" d="M7.750 5.800v4M5.750 7.750h4M16.250 14.200v4M14.250 16.250h4M7.750 14.200v4M5.750 16.250h4"/>)"},
        {"paint",
         R"(<path d="M20.500 3.500L11 13"/><path stroke="C" fill="C" fill-opacity=".350" d="M11 13c-2.500-1-5 .500-5.200 3-.100 1.800-.900 2.800-2.300 3.300 3.500 1.700 9.500 1 9.300-3.300 0-1.200-.700-2.400-1.800-3z"/>)"},
        {"mark",
         R"(<path d="M14.500 3.500l6 6-9 9-6-6z"/><path stroke="C" fill="C" d="M5.500 12.500l6 6-4 1.200-3.200-3.200z"/><path stroke="C" d="M3 21c5-1 12-1.500 18-.500"/>)"},
        {"fill",
         R"(<path d="M3.500 10h17c0 6-3.500 10.500-8.500 10.500S3.500 16 3.500 10z"/><path stroke="C" fill="C" fill-opacity=".350" d="M4 13h16c-1 4.500-4 7.500-8 7.500s-7-3-8-7.500z"/><path d="M12 1.500v6M9.500 5L12 7.500 14.500 5"/>)"},
        {"unfill",
         R"(<path d="M3.500 10h17c0 6-3.500 10.500-8.500 10.500S3.500 16 3.500 10z" stroke-dasharray="2.500 2"/><path stroke="C" d="M12 8V2M9.500 4.500L12 2l2.500 2.500"/>)"},
        {"measure",
         R"(<path d="M3 15.500L15.500 3 21 8.500 8.500 21z"/><path stroke="C" d="M6.500 12l2 2M9.500 9l3 3M12.500 6l2 2"/>)"},
        {"enlarge", R"(<path d="M14 4h6v6M20 4l-7 7M10 20H4v-6M4 20l7-7"/>)"},
        {"freeform", R"(<path d="M5 15C3 9 8 4 12 7s6-2 8 3-4 10-8 9-6 1-7-4z"/>)"},
        {"ellipse", R"(<ellipse cx="12" cy="12" rx="9" ry="6.500"/>)"},
        {"circle", R"(<circle cx="12" cy="12" r="8"/><circle cx="12" cy="12" r=".600" stroke="C"/>)"},
        {"rectangle", R"(<path d="M3.500 6h17v12h-17z"/>)"},
        {"polyline",
         R"(<path d="M5 17L8 6l9 2 3 8-8-2z"/><circle cx="5" cy="17" r="1.300" stroke="C" fill="C"/><circle cx="8" cy="6" r="1.300" stroke="C" fill="C"/><circle cx="17" cy="8" r="1.300" stroke="C" fill="C"/>)"},
        {"stencil",
         R"(<path d="M3.500 5h17v14h-17z"/><path stroke="C" d="M12 8l1.500 3 3.300.500-2.400 2.300.600 3.300-3-1.600-3 1.600.600-3.300-2.400-2.300 3.300-.500z"/>)"},
        {"flipAcross",
         R"(<path d="M9.500 7v10H3.500z"/><path stroke="C" d="M14.500 7v10h6z"/><path stroke-dasharray="2.500 2.500" d="M12 3.500v17"/>)"},
        {"flipDown",
         R"(<path d="M7 9.500h10V3.500z"/><path stroke="C" d="M7 14.500h10v6z"/><path stroke-dasharray="2.500 2.500" d="M3.500 12h17"/>)"},
        {"turnQuarter", R"(<path d="M19 13a7 7 0 1 1-2.300-5.200"/><path stroke="C" d="M17.500 3v5h-5"/>)"},
        {"exchangeAxes",
         R"(<path d="M4.500 20V5.500M4.500 20H19"/><path stroke="C" d="M9 6.500c5 0 8.500 3.500 8.500 8.500M11.500 4L9 6.500 11.500 9M15 12.500l2.500 2.500 2.500-2.500"/>)"},
        {"clear", R"(<path d="M6 6l12 12M18 6L6 18"/>)"},
        {"undo", R"(<path d="M8 5L4 9l4 4"/><path d="M4 9h10a5.500 5.500 0 0 1 0 11H9"/>)"},
        {"redo", R"(<path d="M16 5l4 4-4 4"/><path d="M20 9H10a5.500 5.500 0 0 0 0 11h5"/>)"},
        {"uncut",
         R"(<path d="M12 20.500a8.500 8.500 0 1 1 8.500-8.500H12z"/><path stroke="C" d="M15 18h6M18 15v6"/>)"},
        {"reseed",
         R"(<path d="M12 21v-9"/><path d="M12 12c0-5 3.500-7.500 8-7.500 0 5-3 7.500-8 7.500z"/><path stroke="C" d="M3 5l5 5M8 5l-5 5"/>)"},
        {"play", R"(<path fill="C" stroke="C" d="M7 4.500l12 7.500-12 7.500z"/>)"},
        {"stop", R"(<path stroke-width="2" d="M7 7h10v10H7z"/>)"},
        {"pause", R"(<path stroke-width="3.500" d="M8.500 6v12M15.500 6v12"/>)"},
        {"step", R"(<path d="M6 5l9 7-9 7zM18.500 5v14"/>)"},
        {"back", R"(<path d="M18 5l-9 7 9 7zM5.500 5v14"/>)"},
        {"end", R"(<path d="M4 5l7 7-7 7zM11 5l7 7-7 7zM20.500 5v14"/>)"},
        {"backward", R"(<path fill="C" stroke="C" d="M17 4.500L5 12l12 7.500z"/>)"},
        {"eye",
         R"(<path d="M2.500 12c4-7.500 15-7.500 19 0-4 7.500-15 7.500-19 0z"/><circle cx="12" cy="12" r="3" stroke="C" fill="C"/>)"},
        {"eyeOff",
         R"(<path stroke-opacity=".450" d="M3 10.500c4 6 14 6 18 0M5.500 13.500L4 16M12 15v3M18.500 13.500L20 16"/>)"},
        {"lock",
         R"(<path stroke="C" fill="C" fill-opacity=".350" d="M5.500 11h13v9h-13z"/><path d="M8 11V8a4 4 0 0 1 8 0v3"/>)"},
        {"unlock",
         R"(<path stroke-opacity=".450" d="M5.500 11h13v9h-13z"/><path stroke-opacity=".450" d="M8 11V7.500a4 4 0 0 1 7.600-1.500"/>)"},
        {"spare",
         R"(<path stroke="C" d="M12 3.500l7 2.500v5.500c0 4.500-3 7.500-7 9-4-1.500-7-4.500-7-9V6z"/>)"},
        {"takeOnly",
         R"(<circle cx="12" cy="12" r="4" stroke="C" fill="C"/><path stroke="C" d="M12 2.500v3.500M12 18v3.500M2.500 12H6M18 12h3.500"/>)"},
        {"island",
         R"(<path d="M3.500 10c0-4 4-6 7-5s4 5 1.500 7-8.500 2-8.500-2z"/><circle cx="17.500" cy="17" r="3.500" stroke="C" fill="C" fill-opacity=".350"/><path stroke="C" d="M15.500 15l4 4M19.500 15l-4 4"/>)"},
        {"start",
         R"(<path d="M4 4h6.500v6.500H4zM13.500 4H20v6.500h-6.500zM4 13.500h6.500V20H4z"/><path stroke="C" d="M13.500 13.500H20V20h-6.500z"/>)"},
        {"history", R"(<circle cx="12.500" cy="12" r="8"/><path stroke="C" d="M12.500 7.500V12l3.500 2"/>)"},
        {"note", R"(<path d="M4 4.500h16V16h-9l-4.500 4v-4H4z"/><path stroke="C" d="M8 8.500h8M8 12h5"/>)"},
        {"keys",
         R"(<path d="M2.500 6h19v12h-19z"/><path stroke="C" d="M8 14.500h8"/><path d="M6 10h.500M10 10h.500M14 10h.500M18 10h.500"/>)"},
        {"preferences",
         R"(<path d="M4 7h9M17 7h3M4 17h3M11 17h9M4 12h2"/><circle cx="15" cy="7" r="2" stroke="C"/><circle cx="9" cy="17" r="2" stroke="C"/><path d="M6 12h14"/>)"},
        {"recover",
         R"(<path d="M12 20.500a8.500 8.500 0 1 0-8.500-8.500"/><path d="M3.500 6.500V12H9"/><path stroke="C" d="M12 7.500V12l3 2"/>)"},
        {"raw",
         R"(<path d="M12 3.500l7.500 4.200v8.600L12 20.500l-7.500-4.200V7.700z"/><path d="M4.500 7.700L12 12l7.500-4.300M12 12v8.500"/>)"},
        {"about", R"(<circle cx="12" cy="12" r="8.500"/><path d="M12 11v5.500M12 7.500v.500"/>)"},
    };

class LineIcon : public QIconEngine {
public:
    explicit LineIcon(std::string name) : name_(std::move(name)) {}

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override {
        const bool isDisabled = mode == QIcon::Disabled;
        const QString line = (isDisabled ? theme::kDisabled : theme::kText).name();
        QString shape = kShapes.at(name_);
        shape.replace("\"C\"", "\"" + (isDisabled ? theme::kDisabled : theme::kAccent).name() + "\"");
        const QString svg =
            "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 24 24'><g fill='none' stroke='" + line +
            "' stroke-width='1.7' stroke-linecap='round' stroke-linejoin='round'>" + shape + "</g></svg>";
        QSvgRenderer renderer(svg.toUtf8());
        painter->setRenderHint(QPainter::Antialiasing);
        renderer.render(painter, rect);
    }

    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
        QPixmap pixmap(size);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        paint(&painter, QRect(QPoint(0, 0), size), mode, state);
        return pixmap;
    }

    [[nodiscard]] QIconEngine* clone() const override { return new LineIcon(*this); }

private:
    std::string name_;
};

} // namespace

QIcon icon(const char* name) {
    VS_CHECK(kShapes.count(name) == 1);
    return QIcon(new LineIcon(name));
}

} // namespace vs::desktop
