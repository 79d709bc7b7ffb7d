/// The measures of the scene in the image, and, while one measures, the mouse that sets their points: what
/// the pointer catches is marked, a click sets a point there, Shift keeps to the axis of the scene along
/// which it is farther from the last one. Enter, a double click and Esc end a chain, Esc ends measuring,
/// Backspace and Delete take the last point back. Measures are seen through walls: where something hides an
/// end, lines are dashed and labels pale.
#pragma once

#include "gui/models/measure_texts.h"
#include "gui/models/scene_image.h"
#include "gui/models/scene_state.h"
#include "gui/session/server_status.h"

#include <QObject>
#include <QPointF>
#include <QString>

#include <optional>
#include <vector>

class QKeyEvent;
class QMouseEvent;
class QPainter;

namespace gui {

class FrameView;
class HiddenMeasures;
class Session;

/// What a pointer catches: the word of `measure point`, and where, in scene units from the scene's zero.
struct CaughtPoint {
    QString kind;
    rtcore::Vec3d point;
};
/// Of the answer "corner 1 0 2.5" in the coordinates of the model's file; nothing: it is none.
std::optional<CaughtPoint> readCaught(const QString& answer, const rtcore::LocalOrigin& origin);

class MeasureMarks : public QObject {
    Q_OBJECT

  public:
    /// Both must outlive it.
    MeasureMarks(FrameView& view, Session& session, QObject* parent);

    void setShown(bool shown);
    void setState(const SceneState& state);
    /// Forgets points that are set.
    void setMeasuring(std::optional<rtcore::MeasureKind> kind);
    std::optional<rtcore::MeasureKind> measuring() const { return kind_; }
    const std::vector<rtcore::Vec3d>& points() const { return points_; } ///< that are set
    const std::optional<CaughtPoint>& caught() const { return caught_; } ///< at the pointer
    /// Where labels are painted, widget pixels, measure by measure.
    std::vector<QPointF> labelPlaces() const;
    /// Whether a line of a measure, from one of its points, from 0, to the next, has a hidden end.
    bool isDimmed(std::size_t measure, std::size_t leg) const;
    /// Whether the measure has any hidden point.
    bool isDimmed(std::size_t measure) const;
    /// Where the image shows a point; nothing where it does not.
    std::optional<QPointF> place(const rtcore::Vec3d& point) const;

  signals:
    /// A command that keeps a measure of points.
    void kept(const std::string& line);
    /// The face, or the part, at this point of the image, 0..1 from the left and from the top, is to be kept.
    void faceWanted(const QPointF& at);
    void partWanted(const QPointF& at);
    void nothingCaught();
    void pointsChanged(); ///< set, or taken back
    void removalWanted(); ///< of the selected measure
    void left();          ///< one has ended measuring

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    std::optional<SceneImage> image() const;
    void onFrame();
    void look(const QPointF& at);
    void ask();
    void onCaught(const QPointF& at, const View& view, const QString& answer);
    bool press(const QMouseEvent& event);
    bool release(const QMouseEvent& event);
    bool key(const QKeyEvent& event);
    void click(const QPointF& at, bool onAxis);
    void onClicked(const QString& answer, bool onAxis);
    void setPoint(rtcore::Vec3d point, bool onAxis);
    rtcore::Vec3d heldTo(rtcore::Vec3d point, bool onAxis) const;
    std::size_t wantedPoints() const;
    void end();
    void keep();
    void forgetPoints();
    void draw(QPainter& painter) const;
    void drawMeasures(QPainter& painter, const SceneImage& in) const;
    void drawPending(QPainter& painter, const SceneImage& in) const;
    void drawLines(QPainter& painter, const SceneImage& in, std::size_t measure) const;
    void drawLabels(QPainter& painter, const SceneImage& in, std::size_t measure) const;
    void drawLabel(QPainter& painter, const SceneImage& in, const MeasureLabel& label,
                   bool dimmed = false) const;
    void askWhatIsHidden();
    bool isLeft(rtcore::Vec3d point) const;

    FrameView& view_;
    Session& session_;
    HiddenMeasures* hidden_;
    SceneState state_;
    bool shown_ = true;
    std::optional<rtcore::MeasureKind> kind_;
    std::vector<rtcore::Vec3d> points_;
    std::optional<CaughtPoint> caught_;
    std::optional<QPointF> pointer_, pressed_; ///< widget pixels
    View seen_, askedAt_;                      ///< of the last frame, and where the pointer was asked about
    bool shift_ = false;                       ///< is down
    bool asking_ = false;                      ///< what the pointer catches; answers come one by one
    bool asksAgain_ = false;                   ///< it has moved since
    int waiting_ = 0;                          ///< clicks whose points are not there yet
    bool ends_ = false;                        ///< the chain, with the last of them
    quint64 round_ = 0;                        ///< of points that belong together
};

} // namespace gui
