/// A picture from a file, as large as the window allows.
#pragma once

#include <QDialog>
#include <QImage>

namespace gui {

class PictureDialog : public QDialog {
    Q_OBJECT

  public:
    explicit PictureDialog(const QString& file, QWidget* parent = nullptr);
    bool readable() const { return !picture_.isNull(); }

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    QImage picture_;
};

} // namespace gui
