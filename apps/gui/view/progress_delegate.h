/// Paints a cell as a bar of progress.
#pragma once

#include <QStyledItemDelegate>

namespace gui {

/// The model gives 0..1 in `fractionRole`, or nothing where it is not known, and in `runningRole` whether
/// there is a bar at all; the text is the display's.
class ProgressDelegate : public QStyledItemDelegate {
    Q_OBJECT

  public:
    ProgressDelegate(int fractionRole, int runningRole, QObject* parent = nullptr);
    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;

  private:
    int fractionRole_, runningRole_;
};

} // namespace gui
