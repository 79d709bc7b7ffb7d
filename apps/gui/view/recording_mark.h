/// A red mark with the time over the viewport, while the walk is recorded.
#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

namespace gui {

class FrameView;

/// In the middle of its view, below the line of the overlay; the mouse goes through it.
class RecordingMark : public QWidget {
    Q_OBJECT

  public:
    explicit RecordingMark(FrameView& view);

    /// From now on it counts from there.
    void start(double seconds);
    void stop();
    /// "0:07", "1:02:05"
    QString time() const;

  protected:
    void paintEvent(QPaintEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void fit();

    QElapsedTimer clock_;
    double before_ = 0; ///< seconds that were recorded when the clock started
    QTimer timer_;
};

} // namespace gui
