/// The viewport: the server's newest frame, or a better image rendered by another program.
#pragma once

#include "gui/models/picture_origin.h"
#include "gui/session/session.h"
#include "gui/view/fade.h"

#include <QImage>
#include <QTimer>
#include <QWidget>

#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace gui {

class InputCapture;

class FrameView : public QWidget {
    Q_OBJECT

  public:
    /// `session` must outlive it.
    explicit FrameView(Session& session, QWidget* parent = nullptr);

    InputCapture& input() { return *input_; }

    void setIgnoreAspectRatio(bool on);
    void setSmoothTransformation(bool on);
    void setShowOverlay(bool on);
    /// Colours a picture whose errors are known by these.
    void setShowErrors(bool on);
    /// A short line at the bottom of the image, for some seconds.
    void tell(const QString& text);
    /// Appended to the overlay: other activity, such as rendering; empty = nothing.
    void setActivity(const QString& text);
    /// The same for sharing in web pages.
    void setSharing(const QString& text);

    /// Shows this one instead of the live frames, until showLive(). The first one by paths, which bring more
    /// light, fades in. `errors`: of its pixels (PreviewPicture); null: not known.
    void showPicture(const QImage& picture, const PictureOrigin& origin = {}, const QImage& errors = {});
    void showLive();
    /// Drawn over the image, stretched to its size; null: nothing.
    void setMark(const QImage& mark);
    const QImage& mark() const { return mark_; }
    bool showsLive() const { return picture_.isNull(); }
    const QString& activity() const { return activity_; } ///< in a few words
    const QString& sharing() const { return sharing_; }
    const QString& told() const { return told_; }           ///< by tell(), as long as it is seen
    const QImage& picture() const { return picture_; }      ///< null while it shows live frames
    const PictureOrigin& origin() const { return origin_; } ///< of picture()
    /// The visible image without words, marks and a fade: picture(), or the live frame.
    QImage shown() const { return showsLive() ? session_.frame() : picture_; }
    const QImage& errors() const { return errors_; } ///< of picture(); null: not known
    bool fades() const { return fade_.active(); }

    /// Draws over the image, below words, and over what was added before; called with each painting.
    void addMarks(std::function<void(QPainter&)> draw) { drawMarks_.push_back(std::move(draw)); }
    /// Clicks are for something that was switched on, such as measuring: handles in the image leave them.
    void takeClicks(bool taken) { clicksTaken_ = taken; }
    bool clicksTaken() const { return clicksTaken_; }
    /// Where the image is, in widget pixels; empty without one.
    QRectF pictureArea() const;
    /// Where a point of the widget is in the image: from -1 (left, bottom) to 1; nothing beside it.
    std::optional<QPointF> inPicture(const QPointF& position) const;

    /// The size of the largest image that the view can show in full, in the screen's own pixels.
    QSize devicePixels() const;
    QSize sizeHint() const override;
    /// From a frame's publication by the server until it was painted, averaged over the last ones; seconds.
    double paintDelay() const { return paintDelay_; }

  signals:
    /// The user has changed the window's size, and has come to rest.
    void resolutionWanted(const QSize& devicePixels);

  protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

  private:
    QRectF target(const QSize& picture) const;
    void onStatus();
    void countDelay();
    void drawPicture(QPainter& painter, const QImage& picture, const QRect& dirty) const;
    void colourErrors();
    void drawErrors(QPainter& painter) const;
    void drawFading(QPainter& painter, const QRect& dirty) const;

    Session& session_;
    InputCapture* input_;
    bool clicksTaken_ = false;
    std::vector<std::function<void(QPainter&)>> drawMarks_;
    QImage picture_; ///< null: the live frame
    PictureOrigin origin_;
    QImage errors_;   ///< of picture_; null: not known
    QImage coloured_; ///< picture_ by its errors, where these are shown
    Fade fade_;
    QImage mark_;
    bool ignoreAspectRatio_ = false, smooth_ = true, showOverlay_ = true, showErrors_ = false;
    QString told_, activity_, sharing_, words_; ///< the last: in the middle, as painted
    QTimer tellTimer_, resizeTimer_;
    View view_;           ///< of the last frame
    bool still_ = false;  ///< it was the same as that of the frame before
    quint64 painted_ = 0; ///< number of the frame
    double paintDelay_ = 0;
};

} // namespace gui
