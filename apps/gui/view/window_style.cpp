#include "gui/view/window_style.h"

#include <QPainter>
#include <QStyleOption>

namespace gui {

namespace {

// Halfway from the ground to the letters: enough contrast on either ground.
QColor outlineOf(const QPalette& palette) {
    const QColor ground = palette.color(QPalette::Base), letters = palette.color(QPalette::Text);
    return {(ground.red() + letters.red()) / 2, (ground.green() + letters.green()) / 2,
            (ground.blue() + letters.blue()) / 2};
}

} // namespace

WindowStyle::WindowStyle() : QProxyStyle(QStringLiteral("Fusion")) {}

void WindowStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                                const QWidget* widget) const {
    QProxyStyle::drawPrimitive(element, option, painter, widget);
    const bool round = element == PE_IndicatorRadioButton;
    if (!round && element != PE_IndicatorCheckBox) return;
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setPen(outlineOf(option->palette));
    painter->setBrush(Qt::NoBrush);
    const QRectF edge = QRectF(option->rect).adjusted(0.5, 0.5, -0.5, -0.5);
    round ? painter->drawEllipse(edge) : painter->drawRect(edge);
    painter->restore();
}

int WindowStyle::styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                           QStyleHintReturn* data) const {
    if (hint == SH_DialogButtonBox_ButtonsHaveIcons) return 0;
    return QProxyStyle::styleHint(hint, option, widget, data);
}

} // namespace gui
