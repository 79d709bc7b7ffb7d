#include "gui/view/theme.h"

#include "gui/view/window_style.h"

#include <QApplication>
#include <QPalette>
#include <QString>

namespace gui {

namespace {

QPalette darkPalette() {
    const QColor window(56, 58, 63), base(30, 32, 35), text(225, 227, 230), accent(64, 132, 198);
    QPalette palette(window, window); // the shades of frames are made from these
    palette.setColor(QPalette::WindowText, text);
    palette.setColor(QPalette::Base, base);
    palette.setColor(QPalette::AlternateBase, QColor(38, 40, 44));
    palette.setColor(QPalette::Text, text);
    palette.setColor(QPalette::ButtonText, text);
    palette.setColor(QPalette::BrightText, Qt::white);
    palette.setColor(QPalette::ToolTipBase, base);
    palette.setColor(QPalette::ToolTipText, text);
    palette.setColor(QPalette::PlaceholderText, QColor(140, 143, 148));
    palette.setColor(QPalette::Link, QColor(110, 175, 235));
    palette.setColor(QPalette::LinkVisited, QColor(170, 150, 225));
    palette.setColor(QPalette::Highlight, accent);
    palette.setColor(QPalette::HighlightedText, Qt::white);
    const QColor dim(125, 128, 133);
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        palette.setColor(QPalette::Disabled, role, dim);
    palette.setColor(QPalette::Disabled, QPalette::Highlight, QColor(80, 82, 86));
    return palette;
}

QPalette lightPalette() {
    const QColor window(240, 240, 240);
    QPalette palette(window, window);
    palette.setColor(QPalette::Base, Qt::white);
    palette.setColor(QPalette::Text, Qt::black);
    palette.setColor(QPalette::WindowText, Qt::black);
    palette.setColor(QPalette::ButtonText, Qt::black);
    palette.setColor(QPalette::Highlight, QColor(48, 110, 175));
    palette.setColor(QPalette::HighlightedText, Qt::white);
    const QColor dim(150, 150, 150);
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        palette.setColor(QPalette::Disabled, role, dim);
    return palette;
}

} // namespace

void useTheme(const QString& name) {
    QApplication::setStyle(new WindowStyle);
    if (name == QLatin1String("dark")) {
        QApplication::setPalette(darkPalette());
    } else if (name == QLatin1String("light")) {
        QApplication::setPalette(lightPalette());
    } else {
        QApplication::setPalette(QPalette()); // nothing of ours: the platform's shows through
    }
}

} // namespace gui
