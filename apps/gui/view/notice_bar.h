/// A bar above the image that explains what went wrong and offers what to do.
#pragma once

#include <QFrame>
#include <QList>

class QHBoxLayout;
class QPushButton;
class QAction;

namespace gui {

class PlainLabel;

class NoticeBar : public QFrame {
    Q_OBJECT

  public:
    explicit NoticeBar(QWidget* parent = nullptr);
    /// Each action becomes a button; a button to close the bar is always there.
    void explain(const QString& text, const QList<QAction*>& actions);
    const QString& text() const { return text_; } ///< as it was given

  private:
    QString text_;
    PlainLabel* label_;
    QHBoxLayout* buttons_;
};

} // namespace gui
