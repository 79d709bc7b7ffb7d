#include "gui/view/progress_delegate.h"

#include <QApplication>
#include <QPainter>
#include <QStyle>
#include <QStyleOptionProgressBar>

namespace gui {

ProgressDelegate::ProgressDelegate(int fractionRole, int runningRole, QObject* parent)
    : QStyledItemDelegate(parent), fractionRole_(fractionRole), runningRole_(runningRole) {}

void ProgressDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                             const QModelIndex& index) const {
    const QVariant fraction = index.data(fractionRole_);
    QStyleOptionViewItem row = option;
    initStyleOption(&row, index);
    row.text.clear();
    const QStyle* style = option.widget != nullptr ? option.widget->style() : QApplication::style();
    style->drawControl(QStyle::CE_ItemViewItem, &row, painter, option.widget);
    if (!fraction.isValid() && !index.data(runningRole_).toBool()) return;
    constexpr int kWhole = 1000, kMargin = 3;
    QStyleOptionProgressBar bar;
    bar.initFrom(option.widget);
    bar.palette = option.palette;
    bar.state = QStyle::State_Enabled | QStyle::State_Horizontal;
    bar.rect = option.rect.adjusted(kMargin, kMargin, -kMargin, -kMargin);
    bar.fontMetrics = option.fontMetrics;
    bar.minimum = 0;
    bar.maximum = kWhole;
    bar.progress = static_cast<int>(fraction.toDouble() * kWhole);
    bar.text = index.data(Qt::DisplayRole).toString();
    bar.textVisible = true;
    bar.textAlignment = Qt::AlignCenter;
    style->drawControl(QStyle::CE_ProgressBar, &bar, painter, option.widget);
}

// Room for the bar's text.
QSize ProgressDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
    constexpr int kAround = 10;
    const QSize size = QStyledItemDelegate::sizeHint(option, index);
    return {size.width(), qMax(size.height(), option.fontMetrics.height() + kAround)};
}

} // namespace gui
