/// An image that can be looked at closely: fitted into the widget, or at any scale, and moved by the mouse
/// or the arrow keys. The wheel zooms; a double click leads from the fitted image to its own pixels and
/// back.
#pragma once

#include <QGraphicsView>
#include <QImage>

class QGraphicsPixmapItem;

namespace gui {

class PictureView : public QGraphicsView {
    Q_OBJECT

  public:
    explicit PictureView(QWidget* parent = nullptr);

    void setPicture(const QImage& picture);
    /// All of the image, as large as it gets, but never more than a pixel for a pixel; stays so when the
    /// widget is resized.
    void fit();
    /// Pixels of the screen for one of the image, within 1/32 and 32, about the middle.
    void setZoom(double zoom);
    double zoom() const;
    bool fitted() const { return fitted_; }

  signals:
    void zoomChanged();

  protected:
    void resizeEvent(QResizeEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;

  private:
    void scaleTo(double zoom);

    QGraphicsPixmapItem* item_;
    bool fitted_ = true;
};

} // namespace gui
