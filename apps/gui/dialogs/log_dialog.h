/// A text that grows, such as a program's log.
#pragma once

#include <QDialog>
#include <QTimer>

#include <functional>

class QPlainTextEdit;

namespace gui {

class LogDialog : public QDialog {
    Q_OBJECT

  public:
    /// `read` gives the whole text; it is called every second while the dialog is open.
    explicit LogDialog(std::function<QString()> read, QWidget* parent = nullptr);

  private:
    void refresh();

    std::function<QString()> read_;
    QPlainTextEdit* text_;
    QTimer timer_;
};

} // namespace gui
