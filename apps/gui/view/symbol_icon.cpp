#include "gui/view/symbol_icon.h"

#include "gui/view/painted_icon.h"
#include "gui/view/symbol_path.h"

#include <QGuiApplication>
#include <QPainter>
#include <QPalette>

#include <algorithm>
#include <utility>

namespace gui {

namespace {

class SymbolEngine : public PaintedIcon {
  public:
    explicit SymbolEngine(QPainterPath path) : path_(std::move(path)) {}

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override {
        constexpr double kThick = 1.8; // as on the page
        const auto group = mode == QIcon::Disabled ? QPalette::Disabled : QPalette::Active;
        const double scale = static_cast<double>(std::min(rect.width(), rect.height())) / kSymbolSide;
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        painter->translate(rect.topLeft());
        painter->scale(scale, scale);
        painter->setPen(QPen(QGuiApplication::palette().color(group, QPalette::ButtonText), kThick,
                             Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter->drawPath(path_);
        painter->restore();
    }
    QIconEngine* clone() const override { return new SymbolEngine(path_); }

  private:
    QPainterPath path_;
};

} // namespace

QIcon symbolIcon(const QString& name) { return QIcon(new SymbolEngine(symbolPath(name))); }

} // namespace gui
