/// A column of fields that scrolls up and down only.
#pragma once

#include <QScrollArea>

namespace gui {

/// Never narrower than its column has to be, so that nothing is cut off at the right. It stays as wide as it
/// was, whatever of the column is hidden later.
class ColumnArea : public QScrollArea {
    Q_OBJECT

  public:
    /// Takes `column` over.
    explicit ColumnArea(QWidget* column, QWidget* parent = nullptr);

    QSize minimumSizeHint() const override;

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void widen();

    int width_ = 0; ///< of the column
};

} // namespace gui
