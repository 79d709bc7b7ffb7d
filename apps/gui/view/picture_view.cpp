#include "gui/view/picture_view.h"

#include <QGraphicsPixmapItem>
#include <QGraphicsScene>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace gui {

namespace {

constexpr double kSmallest = 1.0 / 32, kLargest = 32;

} // namespace

PictureView::PictureView(QWidget* parent) : QGraphicsView(parent), item_(new QGraphicsPixmapItem) {
    auto* scene = new QGraphicsScene(this);
    scene->addItem(item_);
    setScene(scene);
    setDragMode(ScrollHandDrag);
    setFrameShape(NoFrame);
    setTransformationAnchor(AnchorUnderMouse);
    setBackgroundBrush(QColor(30, 32, 35)); // an image looks the same in each theme
}

void PictureView::setPicture(const QImage& picture) {
    item_->setPixmap(QPixmap::fromImage(picture));
    scene()->setSceneRect(item_->boundingRect());
    fit();
}

double PictureView::zoom() const { return transform().m11() * devicePixelRatioF(); }

// Large pixels are to be seen as such.
void PictureView::scaleTo(double zoom) {
    const double scale = zoom / devicePixelRatioF();
    item_->setTransformationMode(zoom < 2 ? Qt::SmoothTransformation : Qt::FastTransformation);
    setTransform(QTransform::fromScale(scale, scale));
    emit zoomChanged();
}

void PictureView::fit() {
    fitted_ = true;
    const QSizeF picture = item_->boundingRect().size(),
                 room = QSizeF(maximumViewportSize()) * devicePixelRatioF();
    if (picture.isEmpty() || room.isEmpty()) return;
    scaleTo(std::min({room.width() / picture.width(), room.height() / picture.height(), 1.0}));
}

void PictureView::setZoom(double zoom) {
    fitted_ = false;
    setTransformationAnchor(AnchorViewCenter);
    scaleTo(std::clamp(zoom, kSmallest, kLargest));
    setTransformationAnchor(AnchorUnderMouse);
}

void PictureView::resizeEvent(QResizeEvent* event) {
    QGraphicsView::resizeEvent(event);
    if (fitted_) fit();
}

void PictureView::wheelEvent(QWheelEvent* event) {
    constexpr double kDoubling = 480; // four notches
    fitted_ = false;
    scaleTo(std::clamp(zoom() * std::exp2(event->angleDelta().y() / kDoubling), kSmallest, kLargest));
    event->accept();
}

void PictureView::mouseDoubleClickEvent(QMouseEvent*) { fitted_ ? setZoom(1) : fit(); }

} // namespace gui
