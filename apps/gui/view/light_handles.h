/// The marks of lights in the image, and the mouse that selects and moves lights by them. A mark that is
/// dragged moves its light parallel to the image, by one of its three handles along that axis, with Shift
/// along the surfaces under the pointer. A light that has no position is marked where it comes from, as the
/// sun in the sky; dragging that mark turns the light. Marks are seen through walls.
#pragma once

#include "gui/models/scene_image.h"
#include "gui/models/scene_state.h"

#include <QColor>
#include <QList>
#include <QObject>
#include <QPointF>
#include <QString>
#include <QVector3D>

#include <optional>

class QMouseEvent;
class QPainter;

namespace gui {

class FrameView;
class Session;

struct LightMark {
    int id = 0;
    bool on = true;
    QString name;
    QColor colour;
    QVector3D position;                      ///< of one that is far: the direction to it
    std::optional<QVector3D> direction = {}; ///< where it shines to, unit length; of one that is near
    bool far = false;                        ///< endlessly
};

/// Keys and mouse stay the camera's while the view has captured them.
class LightHandles : public QObject {
    Q_OBJECT

  public:
    /// Both must outlive it.
    LightHandles(FrameView& view, Session& session, QObject* parent);

    void setShown(bool shown);
    /// `state`: of the scene that they are in.
    void setMarks(const QList<LightMark>& marks, const SceneState& state);
    void setSelected(int id); ///< 0: none
    /// Where the mark of a light is drawn, widget pixels; nothing when it is not.
    std::optional<QPointF> place(int id) const;
    /// Where the handle for an axis (0, 1, 2) of the selected light ends.
    std::optional<QPointF> handle(int axis) const;

  signals:
    void picked(int id);
    /// `goesOn`: after the first one of a drag.
    void moved(int id, const QVector3D& position, bool goesOn);
    /// A light that is far, so that it comes from this direction, of unit length.
    void turned(int id, const QVector3D& towards, bool goesOn);
    /// To the surface at this place of the image, 0..1 from the left and from the top.
    void movedOntoSurface(int id, const QPointF& place, bool goesOn);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    struct Drag {
        int id;
        std::optional<int> axis;
        QVector3D start; ///< as in LightMark::position
        QPointF from, now;
        bool moves = false; ///< far enough for no mere click
        bool onSurface = false;
    };

    std::optional<SceneImage> image() const;
    const LightMark* find(int id) const;
    const LightMark* markAt(const QPointF& at) const;
    std::optional<int> axisAt(const QPointF& at) const;
    QVector3D positionOf(const LightMark& mark) const;
    std::optional<QPointF> placeOf(const LightMark& mark, const SceneImage& in) const;
    bool press(const QMouseEvent& event);
    void drag(const QMouseEvent& event);
    rtcore::Vec3d dragged(const SceneImage& in) const;
    void dragFar(const SceneImage& in, bool goesOn);
    void showPointer(const QPointF& at);
    void draw(QPainter& painter) const;
    void drawMark(QPainter& painter, const SceneImage& in, const LightMark& mark) const;
    void drawName(QPainter& painter, const LightMark& mark, const QPointF& centre) const;
    void drawHandles(QPainter& painter, const QPointF& centre) const;

    FrameView& view_;
    Session& session_;
    QList<LightMark> marks_;
    SceneState state_;
    int selected_ = 0;
    bool shown_ = false, pointing_ = false;
    std::optional<Drag> drag_;
    std::optional<QVector3D> dropped_; ///< until the server says where the light is
};

} // namespace gui
