/// The marks of lights in the image, and the mouse that selects and moves lights by them. A mark that is
/// dragged moves its light parallel to the image, by one of its three handles along that axis, with Shift
/// along the surfaces under the pointer. Marks are seen through walls.
#pragma once

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
class Projection;
class Session;

/// A light that has a position.
struct LightMark {
    int id = 0;
    bool on = true;
    QString name;
    QColor colour;
    QVector3D position;
    std::optional<QVector3D> direction = {}; ///< where it shines to, unit length
};

/// Keys and mouse stay the camera's while the view has captured them.
class LightHandles : public QObject {
    Q_OBJECT

  public:
    /// Both must outlive it.
    LightHandles(FrameView& view, Session& session, QObject* parent);

    void setShown(bool shown);
    void setMarks(const QList<LightMark>& marks);
    void setSelected(int id); ///< 0: none
    /// Where the mark of a light is drawn, widget pixels; nothing when it is not.
    std::optional<QPointF> place(int id) const;
    /// Where the handle for an axis (0, 1, 2) of the selected light ends.
    std::optional<QPointF> handle(int axis) const;

  signals:
    void picked(int id);
    /// `goesOn`: after the first one of a drag.
    void moved(int id, const QVector3D& position, bool goesOn);
    /// To the surface at this place of the image, 0..1 from the left and from the top.
    void movedOntoSurface(int id, const QPointF& place, bool goesOn);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    struct Drag {
        int id;
        std::optional<int> axis;
        QVector3D start; ///< of the light
        QPointF from, now;
        bool moves = false; ///< far enough for no mere click
        bool onSurface = false;
    };

    std::optional<Projection> projection() const;
    const LightMark* find(int id) const;
    const LightMark* markAt(const QPointF& at) const;
    std::optional<int> axisAt(const QPointF& at) const;
    QVector3D positionOf(const LightMark& mark) const;
    bool press(const QMouseEvent& event);
    void drag(const QMouseEvent& event);
    void showPointer(const QPointF& at);
    void draw(QPainter& painter) const;
    void drawMark(QPainter& painter, const Projection& in, const LightMark& mark) const;
    void drawHandles(QPainter& painter, const QPointF& centre) const;

    FrameView& view_;
    Session& session_;
    QList<LightMark> marks_;
    int selected_ = 0;
    bool shown_ = false, pointing_ = false;
    std::optional<Drag> drag_;
    std::optional<QVector3D> dropped_; ///< until the server says where the light is
};

} // namespace gui
