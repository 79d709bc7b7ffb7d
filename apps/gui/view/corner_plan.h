/// A small plan of a storey in the corner of the viewport, with the camera in it.
#pragma once

#include "gui/models/plan_fit.h"
#include "gui/session/server_status.h"

#include <QPixmap>
#include <QString>
#include <QWidget>

#include <array>
#include <optional>

class QToolButton;

namespace gui {

class FrameView;
class PlainLabel;

/// A click goes there, a drag looks there. Lines are painted once for an outline and a size.
class CornerPlan : public QWidget {
    Q_OBJECT

  public:
    /// Lies over `view`, at its lower right, a quarter of its width at most.
    explicit CornerPlan(FrameView& view);

    /// Another storey, or the same one anew.
    void setOutline(const app::ToldOutline& outline);
    /// In place of a plan.
    void setMessage(const QString& text);
    /// Where the camera is, and on which storey (storeyAt()).
    void setView(const View& view, int storey);

    const app::ToldOutline& outline() const { return outline_; }
    QString title() const;
    /// Where the plan is, in widget pixels; without one it is empty.
    QRectF planArea() const;
    /// Where the camera's mark is: at the edge of the area, where the camera is beside it.
    std::optional<QPointF> mark() const;

  signals:
    /// The plan of another storey, from 1.
    void storeyWanted(int storey);
    /// To be there with the eye, in the coordinates of the model's file; the direction of the view stays.
    void goWanted(const std::array<double, 3>& eye);
    /// To look there. `goesOn`: in the same drag as before.
    void lookWanted(const std::array<float, 3>& forward, bool goesOn);

  protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void layOut();
    void showStoreys();
    PlanFit fit() const { return {outline_, planArea()}; }
    QPixmap paintedLines() const;
    void drawCamera(QPainter& painter) const;

    QWidget& view_;
    app::ToldOutline outline_;
    bool known_ = false; ///< there is an outline
    QString message_;
    View camera_;
    int storey_ = 0; ///< of the camera
    QPixmap lines_;  ///< null: to be painted
    std::optional<QPointF> pressed_;
    bool drags_ = false;
    PlainLabel* title_;
    QToolButton *below_, *above_;
};

} // namespace gui
