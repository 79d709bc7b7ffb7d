/// Fusion, with what it lacks: the outlines of check boxes and radio buttons are seen on a dark ground, too,
/// and the buttons of dialogs have words alone.
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
};

} // namespace gui
