/// An image from a file in a window of its own, to look at, to copy, and to save elsewhere.
#pragma once

#include <QDialog>
#include <QImage>

class QHBoxLayout;

namespace gui {

class PictureView;
class PlainLabel;

class PictureDialog : public QDialog {
    Q_OBJECT

  public:
    explicit PictureDialog(const QString& file, QWidget* parent = nullptr);
    bool readable() const { return !picture_.isNull(); }
    PictureView& view() { return *view_; }
    /// Copies the file as it is, or converts it to the format of another extension. Returns the error, or
    /// nothing; no file is left half-written.
    QString saveTo(const QString& path) const;

  private:
    QWidget* makeButtons();
    template <typename Act>
    void addButton(QHBoxLayout& row, const QString& text, const QString& tip, const QList<QKeySequence>& keys,
                   Act act);
    void chooseSize();
    void showState();
    void saveAs();

    QString file_;
    QImage picture_;
    PictureView* view_;
    PlainLabel* state_;
};

} // namespace gui
