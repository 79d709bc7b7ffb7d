#include "gui/view/window_style.h"

#include "gui/view/painted_icon.h"

#include <QAbstractItemView>
#include <QGuiApplication>
#include <QPainter>
#include <QStyleOption>

#include <algorithm>

namespace gui {

namespace {

// Halfway from the ground to the letters: enough contrast on either ground.
QColor outlineOf(const QPalette& palette) {
    const QColor ground = palette.color(QPalette::Base), letters = palette.color(QPalette::Text);
    return {(ground.red() + letters.red()) / 2, (ground.green() + letters.green()) / 2,
            (ground.blue() + letters.blue()) / 2};
}

/// The signs in the title of a panel, in the colour that letters have at the moment.
class TitleSign : public PaintedIcon {
  public:
    explicit TitleSign(bool cross) : cross_(cross) {}
    void paint(QPainter* painter, const QRect& rect, QIcon::Mode, QIcon::State) override {
        painter->setRenderHint(QPainter::Antialiasing);
        constexpr qreal kThick = 0.09;
        const qreal size = std::min(rect.width(), rect.height());
        painter->setPen(QPen(QGuiApplication::palette().color(QPalette::WindowText), size * kThick));
        const qreal margin = size / 4;
        const QRectF area = QRectF(rect).adjusted(margin, margin, -margin, -margin);
        if (cross_) {
            painter->drawLine(area.topLeft(), area.bottomRight());
            painter->drawLine(area.topRight(), area.bottomLeft());
        } else {
            const qreal step = area.width() / 3; // one window before another
            painter->drawRect(area.adjusted(0, step, -step, 0));
            painter->drawPolyline(QPolygonF{
                {area.left() + step, area.top()}, area.topRight(), {area.right(), area.bottom() - step}});
        }
    }
    QIconEngine* clone() const override { return new TitleSign(cross_); }

  private:
    bool cross_;
};

} // namespace

WindowStyle::WindowStyle() : QProxyStyle(QStringLiteral("Fusion")) {}

void WindowStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                                const QWidget* widget) const {
    // A marked row needs no frame, which would part it between image and name.
    const bool row = qobject_cast<const QAbstractItemView*>(widget) != nullptr;
    if (element == PE_FrameFocusRect && row && (option->state & State_Selected) != 0) return;
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

QIcon WindowStyle::standardIcon(StandardPixmap icon, const QStyleOption* option,
                                const QWidget* widget) const {
    if (icon == SP_TitleBarNormalButton) return QIcon(new TitleSign(false));
    if (icon == SP_DockWidgetCloseButton || icon == SP_TitleBarCloseButton) return QIcon(new TitleSign(true));
    return QProxyStyle::standardIcon(icon, option, widget);
}

} // namespace gui
