/// The handles of sections in the image, and the mouse that moves and turns planes by them: an arrow along
/// each plane's normal, to the side that is taken away, from a point of the plane, whose line around the
/// model's box is painted, too. A plane goes along its normal as the arrow goes with the hand, as far as the
/// box reaches; where the arrow points at the eye, or away from it, upwards leads away. Beside the arrow of
/// the selected plane, which is no side of a box, are two arcs: a hand that drags their knobs turns the plane
/// about the arrow's foot, with Shift in steps of 15 degrees. Esc takes a drag back. Handles are seen through
/// walls.
#pragma once

#include "gui/models/scene_image.h"
#include "gui/models/scene_state.h"
#include "gui/models/section_marks.h"
#include "gui/view/section_arcs.h"

#include <QColor>
#include <QObject>
#include <QPointF>

#include <optional>
#include <vector>

class QKeyEvent;
class QMouseEvent;
class QPainter;

namespace gui {

class FrameView;
class Session;

/// Keys and mouse stay the camera's while the view has captured them.
class SectionHandles : public QObject {
    Q_OBJECT

  public:
    /// Both must outlive it.
    SectionHandles(FrameView& view, Session& session, QObject* parent);

    void setShown(bool shown);
    void setState(const SceneState& state);
    void setSelected(int number); ///< from 1; 0: none
    /// Where the handle of a section, from 1, begins and ends, widget pixels; nothing where it is not
    /// painted. An arrow that points at the eye ends where it begins.
    std::optional<QPointF> place(int number) const;
    std::optional<QPointF> tip(int number) const;
    /// Where the knob is that turns the selected section about one of its TurnAxes, 0 or 1.
    std::optional<QPointF> knob(int axis) const;
    int hovered() const { return hovered_; } ///< 0: none

  signals:
    void picked(int number);
    /// The section is to go through that point of the model's file. `goesOn`: after the first one of a drag.
    void moved(int number, const rtcore::FilePoint& point, bool goesOn);
    /// The same, and is to have that normal.
    void turned(int number, const rtcore::FilePoint& point, const rtcore::Vec3d& normal, bool goesOn);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    struct Handle {
        rtcore::Vec3d hold; ///< scene units
        QPointF place, tip; ///< widget pixels
        bool facing;        ///< it points at the eye, or away from it
    };
    struct Drag {
        int number;
        SectionMark mark;
        Handle handle;
        rtcore::SectionPlane start, now; ///< scene units
        QPointF from;
        std::optional<SectionArc> arc = {}; ///< that turns it
        double along = 0;                   ///< the normal, since the start
        double angle = 0;                   ///< of the hand, since the start; radians
        bool moves = false;
        bool over = false; ///< taken back, while the button is still down
    };

    /// A foot that a drag has left.
    struct Foot {
        int number;
        rtcore::Vec3d hold, normal; ///< scene units
    };

    std::optional<SceneImage> image() const;
    int count() const { return static_cast<int>(state_.sections.planes.size()); }
    SectionMark mark(int number) const;
    std::optional<Handle> handle(int number, const SceneImage& in) const;
    std::optional<rtcore::Vec3d> foot(int number, const SectionMark& at, const SceneImage& in) const;
    std::optional<rtcore::Vec3d> keptFoot(int number, const SectionMark& at, const SceneImage& in) const;
    std::vector<SectionArc> arcs(const SceneImage& in) const;
    std::optional<SectionArc> arcAt(const QPointF& at) const;
    int handleAt(const QPointF& at) const;
    rtcore::SectionPlane& plane(int number);
    bool press(const QMouseEvent& event);
    bool key(const QKeyEvent& event);
    void drag(const QMouseEvent& event);
    void move(const SceneImage& in, const QPointF& to, bool goesOn);
    void turn(const SceneImage& in, const QPointF& to, bool inSteps, bool goesOn);
    void takeBack();
    double led(const SceneImage& in, const QPointF& to) const;
    void endDrag();
    void hover(const QPointF& at);
    void draw(QPainter& painter) const;
    void drawOutline(QPainter& painter, const SceneImage& in, int number) const;
    void drawHandle(QPainter& painter, const Handle& handle, const QColor& colour) const;
    QColor colourOf(int number) const;

    FrameView& view_;
    Session& session_;
    SceneState state_;
    int selected_ = 0, hovered_ = 0;
    int hoveredArc_ = -1; ///< of the selected one; -1: none
    bool shown_ = false;
    std::optional<Drag> drag_;
    std::optional<Foot> foot_; ///< of the last drag
};

} // namespace gui
