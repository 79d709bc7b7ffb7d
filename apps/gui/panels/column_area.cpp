#include "gui/panels/column_area.h"

#include <QEvent>
#include <QScrollBar>

#include <algorithm>

namespace gui {

ColumnArea::ColumnArea(QWidget* column, QWidget* parent) : QScrollArea(parent) {
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setFocusPolicy(Qt::NoFocus);
    setWidget(column);
    widen();
}

QSize ColumnArea::minimumSizeHint() const {
    return {width_ + verticalScrollBar()->sizeHint().width(), QScrollArea::minimumSizeHint().height()};
}

void ColumnArea::widen() {
    const int needed = widget()->minimumSizeHint().width();
    if (needed <= width_) return;
    width_ = needed;
    updateGeometry();
}

bool ColumnArea::eventFilter(QObject* watched, QEvent* event) {
    const bool done = QScrollArea::eventFilter(watched, event);
    if (watched == widget() && event->type() == QEvent::LayoutRequest) widen();
    return done;
}

} // namespace gui
