/// The shown image beside one that was kept: by a divider, in turns, or as their difference.
#pragma once

#include <QImage>
#include <QObject>
#include <QTimer>

class QPainter;

namespace gui {

class FrameView;

enum class CompareMode { Off, Divider, Blink, Difference };

/// Of two images, pixel by pixel and channel by channel.
struct ImageDifference {
    QImage image;    ///< `times` as bright as it is, so that small ones are seen
    double mean = 0; ///< of all channels, 0..255
    int largest = 0; ///< of one channel
    int times = 1;   ///< as much as no channel clips at, 1 to 64
};

/// `kept` is scaled to the size of `now`, which is not null.
ImageDifference differenceOf(const QImage& kept, const QImage& now);

/// Draws over the view, below its words.
class Comparison : public QObject {
    Q_OBJECT

  public:
    explicit Comparison(FrameView& view);

    /// The image to compare with from now on.
    void keep(const QImage& image);
    const QImage& kept() const { return kept_; } ///< null: none
    /// Off, where nothing is kept.
    void show(CompareMode mode);
    CompareMode mode() const { return mode_; }
    /// Where the divider is, 0..1 of the image from the left; left of it is what was kept.
    double divider() const { return divider_; }
    /// Of Blink: the kept image is seen.
    bool showsKept() const { return showsKept_; }

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void draw(QPainter& painter);
    void drawDivider(QPainter& painter, const QRectF& area) const;
    void drawDifference(QPainter& painter, const QRectF& area);
    bool isAtDivider(const QPointF& position) const;
    void moveDivider(double x);
    void showCursor(bool atDivider);

    FrameView& view_;
    QImage kept_;
    CompareMode mode_ = CompareMode::Off;
    double divider_ = 0.5;
    bool drags_ = false, cursorShown_ = false;
    QTimer blink_;
    bool showsKept_ = false;
    qint64 differenceOf_[2] = {}; ///< cache keys of the images of difference_
    ImageDifference difference_;
};

} // namespace gui
