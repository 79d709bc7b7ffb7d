/// The notes of the scene in the image: discs with their numbers, and the text of the one at the pointer.
/// While one is to be added a click sets its point. Notes are seen through walls, as measures are; what a
/// section takes away is not.
#pragma once

#include "gui/models/scene_image.h"
#include "gui/models/scene_state.h"

#include <QObject>
#include <QPointF>

#include <optional>

class QMouseEvent;
class QPainter;

namespace gui {

class FrameView;
class Session;

class NoteMarks : public QObject {
    Q_OBJECT

  public:
    /// Both must outlive it.
    NoteMarks(FrameView& view, Session& session, QObject* parent);

    void setShown(bool shown);
    void setState(const SceneState& state);
    /// A click sets the point of a note; Esc ends that.
    void setAdding(bool adding);
    bool adding() const { return adding_; }
    /// Marks the point of a note that is being written; nothing: none is.
    void setPending(const std::optional<rtcore::Vec3d>& point);
    int hovered() const { return hovered_; } ///< index of the note at the pointer; -1: none
    /// Where the disc of a note is painted, widget pixels; nothing: it is not.
    std::optional<QPointF> place(int index) const;

  signals:
    /// A note is to be added at a point of the server's image: 0..1 from the left and from the top.
    void placed(const QPointF& at);
    void left(); ///< none is to be added any more
    void picked(int index);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    int at(const QPointF& position) const;
    void hover(int index);
    bool press(const QMouseEvent& event);
    bool release(const QMouseEvent& event);
    std::optional<QPointF> placeIn(const SceneImage& image, const rtcore::Vec3d& point) const;
    void draw(QPainter& painter) const;
    void drawText(QPainter& painter, const QPointF& at, const QString& text) const;

    FrameView& view_;
    Session& session_;
    SceneState state_;
    bool shown_ = true, adding_ = false;
    int hovered_ = -1;
    int grasped_ = -1; ///< index of the note whose disc was pressed
    std::optional<QPointF> pressed_;
    std::optional<rtcore::Vec3d> pending_;
};

} // namespace gui
