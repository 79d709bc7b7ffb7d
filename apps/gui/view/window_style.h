/// Fusion, with what it lacks: check boxes, radio buttons and the signs on panels are seen on a dark ground,
/// too; a row of a list is marked as a whole; the buttons of dialogs have words alone.
#pragma once

#include <QProxyStyle>

namespace gui {

class WindowStyle : public QProxyStyle {
    Q_OBJECT

  public:
    WindowStyle();
    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget) const override;
    int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                  QStyleHintReturn* data) const override;
    QIcon standardIcon(StandardPixmap icon, const QStyleOption* option, const QWidget* widget) const override;
};

} // namespace gui
