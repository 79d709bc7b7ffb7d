/// The text of a note and the name of its author, to be written or changed.
#pragma once

#include <QDialog>
#include <QString>

class QDialogButtonBox;
class QLineEdit;
class QPlainTextEdit;
class QPushButton;

namespace gui {

class PlainLabel;

class NoteDialog : public QDialog {
    Q_OBJECT

  public:
    /// `text`: of a note that there is; "": it is a new one.
    NoteDialog(const QString& text, const QString& author, QWidget* parent = nullptr);

    /// Fields, and the button that ends it by written().
    QPlainTextEdit& text() { return *text_; }
    QLineEdit& author() { return *author_; }
    QPushButton& keeping() { return *keep_; }

  signals:
    /// As rtcore::noteText() and noteAuthor() have them; not too long.
    void written(const QString& text, const QString& author);

  private:
    void check();
    void finish();

    QPlainTextEdit* text_;
    QLineEdit* author_;
    PlainLabel* trouble_;
    QPushButton* keep_ = nullptr;
};

} // namespace gui
