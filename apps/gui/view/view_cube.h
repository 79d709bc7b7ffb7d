/// A cube in the corner of the viewport that stands as the model does, and the modes of the mouse below it.
#pragma once

#include "gui/session/server_status.h"

#include <QString>
#include <QVector3D>
#include <QWidget>

#include <array>
#include <optional>

class QButtonGroup;

namespace gui {

class FrameView;

/// How one moves.
enum class Mode { Orbit, Walk, Fly };

class ViewCube : public QWidget {
    Q_OBJECT

  public:
    /// Lies over `view`, at its upper right.
    explicit ViewCube(FrameView& view);

    /// The model's axis, one of the six.
    void setUp(const QVector3D& up);
    void setView(const View& view);
    void setMode(Mode mode);
    Mode mode() const { return mode_; }

    /// The side of the cube, or its corner, that is seen there: as `camera view` names it; empty beside it.
    QString sideAt(const QPointF& position) const;
    /// Where that side's middle is; nothing where it is not seen.
    std::optional<QPointF> middleOf(const QString& side) const;

  signals:
    void sideChosen(const QString& side);
    void modeChosen(gui::Mode mode);

  protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    struct Side {
        const char* name;
        QVector3D normal, right, up; ///< of unit length, as one sees it from before it
    };
    std::array<Side, 6> sides() const;
    QPointF projected(const QVector3D& point) const;
    std::array<QPointF, 4> cornersOf(const Side& side) const;
    bool isSeen(const Side& side) const;
    void place();

    QWidget& view_;
    QVector3D up_{0, 1, 0};
    QVector3D right_{1, 0, 0}, above_{0, 1, 0}, towards_{0, 0, 1}; ///< of the image, in the scene
    Mode mode_ = Mode::Orbit;
    QString hovered_, pressed_;
    QButtonGroup* modes_;
};

} // namespace gui
