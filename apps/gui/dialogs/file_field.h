/// A line for a path, with a button that opens a file dialog.
#pragma once

#include <QWidget>

class QLineEdit;

namespace gui {

class FileField : public QWidget {
    Q_OBJECT

  public:
    enum class Kind { Open, Save, Folder };
    FileField(Kind kind, const QString& title, const QString& filter, QWidget* parent = nullptr);

    QString path() const; ///< absolute; empty when nothing is written
    void setPath(const QString& path);
    QLineEdit* edit() const { return edit_; }

  signals:
    void pathChanged();

  private:
    void browse();

    Kind kind_;
    QString title_, filter_;
    QLineEdit* edit_;
};

} // namespace gui
