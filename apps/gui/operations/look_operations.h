/// The camera's direction by a double click, what it is focused at, its field of view, and the scene's own
/// view.
#pragma once

#include "gui/operations/gui_context.h"

#include <QElapsedTimer>
#include <QObject>
#include <QVariantAnimation>
#include <QVector3D>

class QPointF;

namespace gui {

struct View;

/// The direction from the eye through a point of the image, each coordinate from -1 (left, bottom) to 1;
/// `aspect`: width by height of the image. Unit length.
QVector3D directionThrough(const View& view, const QPointF& inPicture, double aspect);

class LookOperations : public QObject {
    Q_OBJECT

  public:
    LookOperations(const GuiContext& context, QObject* parent);

  private:
    void reset();
    void lookAt(const QPointF& position);
    void focusAt(const QPointF& position);
    void askForAngle();
    void setAngle(double degrees);
    void zoom(double steps);
    void sendZoom();
    bool goesOn();
    void step(double fraction);
    void send(const QVector3D& direction, bool last);

    GuiContext context_;
    QVariantAnimation turn_;
    QVector3D from_, to_;
    bool underWay_ = false;
    bool begun_ = false;   ///< the first step was sent
    double factor_ = 1;    ///< to zoom by, not sent yet
    bool zooming_ = false; ///< an answer is to come
    QElapsedTimer sinceAngle_;
};

} // namespace gui
