#include "gui/view/frame_view.h"

#include "gui/models/plain_text.h"
#include "gui/view/error_colours.h"
#include "gui/view/input_capture.h"
#include "gui/view/overlay.h"

#include "rtcore/upsample/upsample.h"

#include <QPaintEvent>
#include <QPainter>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <new>
#include <utility>

namespace gui {

namespace {

using namespace std::chrono_literals;

constexpr auto kTellFor = 4s;
constexpr auto kResizeRest = 300ms;
constexpr QRgb kBackground = 0xff1a1c1f;

/// The image upsampled along its edges, in the same format, so that a frame of few pixels shows no squares;
/// at most about as large as a widget of `max`, and no larger than takes a few milliseconds.
QImage upsampled(const QImage& picture, const QSize& max) {
    constexpr double kMaxPixels = 1 << 21;
    const double pixels = static_cast<double>(max.width()) * max.height();
    const QSize size = max * std::min(1.0, std::sqrt(kMaxPixels / pixels));
    const bool grows =
        size.width() >= picture.width() && size.height() >= picture.height() && size != picture.size();
    if (!grows || picture.format() != QImage::Format_RGB32) return picture;
    QImage result(size, QImage::Format_RGB32);
    if (result.isNull()) return picture;
    try {
        rtcore::upsample({picture.constBits(), picture.width(), picture.height(), picture.bytesPerLine()}, 1,
                         {result.bits(), size.width(), size.height(), result.bytesPerLine()});
    } catch (const std::bad_alloc&) { // Qt lets no exception through
        return picture;
    }
    return result;
}

} // namespace

FrameView::FrameView(Session& session, QWidget* parent)
    : QWidget(parent), session_(session), input_(new InputCapture(this)) {
    setAttribute(Qt::WA_OpaquePaintEvent); // every pixel is painted: no background below
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(160, 120);
    setAccessibleName(tr("Image"));
    setAccessibleDescription(
        tr("The viewport. Keys move; Enter or a click captures mouse and keyboard, Esc releases them."));
    tellTimer_.setSingleShot(true);
    resizeTimer_.setSingleShot(true);
    connect(&tellTimer_, &QTimer::timeout, this, [this] { tell({}); });
    connect(&resizeTimer_, &QTimer::timeout, this, [this] { emit resolutionWanted(devicePixels()); });
    connect(&session_, &Session::frameChanged, this, [this] {
        const View& now = session_.status().view;
        const View before = std::exchange(view_, now);
        still_ = !before.known() || before == now; // the first one moves as little
        if (showsLive()) update();
    });
    connect(&session_, &Session::statusChanged, this, &FrameView::onStatus);
    connect(&session_, &Session::stateChanged, this, qOverload<>(&QWidget::update));
    connect(&fade_, &Fade::stepped, this, qOverload<>(&QWidget::update));
    connect(input_, &InputCapture::capturedChanged, this, [this](bool captured) {
        tell(captured ? tr("Mouse and keyboard captured. Esc releases them.") : QString());
    });
}

// With every frame comes a status: the image is not painted for each of them.
void FrameView::onStatus() {
    if (stateText(session_) != words_) return update();
    if (showOverlay_) update(0, 0, width(), overlayHeight(fontMetrics()));
}

QSize FrameView::sizeHint() const { return {1024, 640}; }
QSize FrameView::devicePixels() const { return (QSizeF(size()) * devicePixelRatioF()).toSize(); }

void FrameView::setIgnoreAspectRatio(bool on) {
    ignoreAspectRatio_ = on;
    update();
}

void FrameView::setSmoothTransformation(bool on) {
    smooth_ = on;
    update();
}

void FrameView::setShowOverlay(bool on) {
    showOverlay_ = on;
    update();
}

void FrameView::setShowErrors(bool on) {
    if (showErrors_ == on) return;
    showErrors_ = on;
    colourErrors();
    update();
}

void FrameView::colourErrors() { coloured_ = showErrors_ ? colouredByErrors(picture_, errors_) : QImage(); }

void FrameView::tell(const QString& text) {
    told_ = plainText(text);
    tellTimer_.start(kTellFor);
    update();
}

void FrameView::setActivity(const QString& text) {
    if (text == activity_) return;
    activity_ = text;
    update();
}

void FrameView::setSharing(const QString& text) {
    if (text == sharing_) return;
    sharing_ = text;
    update();
}

void FrameView::showPicture(const QImage& picture, const PictureOrigin& origin, const QImage& errors) {
    if (origin.paths && showsLive()) fade_.begin(session_.frame().copy()); // which the next frame takes
    picture_ = picture;
    origin_ = origin;
    errors_ = errors;
    colourErrors();
    update();
}

void FrameView::showLive() {
    if (showsLive()) return;
    picture_ = errors_ = coloured_ = {};
    fade_.end();
    update();
}

void FrameView::setMark(const QImage& mark) {
    if (mark.isNull() && mark_.isNull()) return;
    mark_ = mark;
    update();
}

// In the widget's pixels; one to one on the screen's own when the sizes agree.
QRectF FrameView::target(const QSize& picture) const {
    if (ignoreAspectRatio_ || picture == devicePixels()) return rect();
    QRectF area(QPointF(), QSizeF(picture).scaled(size(), Qt::KeepAspectRatio));
    // A smaller frame of the same view, its sides rounded: no border that comes and goes.
    constexpr double kRounding = 0.01;
    if (area.width() > width() * (1 - kRounding) && area.height() > height() * (1 - kRounding)) return rect();
    area.moveCenter(QRectF(rect()).center());
    return area;
}

QRectF FrameView::pictureArea() const {
    const QSize size = showsLive() ? session_.frame().size() : picture_.size();
    return size.isEmpty() ? QRectF() : target(size);
}

std::optional<QPointF> FrameView::inPicture(const QPointF& position) const {
    const QRectF area = pictureArea();
    if (!area.contains(position)) return std::nullopt;
    const QPointF off = position - area.center();
    return QPointF(2 * off.x() / area.width(), -2 * off.y() / area.height());
}

void FrameView::drawPicture(QPainter& painter, const QImage& picture, const QRect& dirty) const {
    const QColor background = QColor::fromRgb(kBackground);
    if (picture.isNull()) return painter.fillRect(dirty, background);
    const QRectF area = target(picture.size());
    const QRegion border = QRegion(dirty).subtracted(area.toAlignedRect());
    for (const QRect& strip : border) painter.fillRect(strip, background);
    painter.setCompositionMode(QPainter::CompositionMode_Source);
    painter.setRenderHint(QPainter::SmoothPixmapTransform, smooth_);
    painter.drawImage(area,
                      smooth_ ? upsampled(picture, (area.size() * devicePixelRatioF()).toSize()) : picture);
    painter.setCompositionMode(QPainter::CompositionMode_SourceOver);
}

void FrameView::drawFading(QPainter& painter, const QRect& dirty) const {
    drawPicture(painter, fade_.from(), dirty);
    painter.setOpacity(fade_.share());
    painter.drawImage(target(picture_.size()), picture_);
    painter.setOpacity(1);
}

void FrameView::drawErrors(QPainter& painter) const {
    const QRectF area = target(coloured_.size());
    painter.drawImage(area, coloured_);
    drawErrorLegend(painter, rect());
    drawLargestError(painter, area, errors_);
}

void FrameView::countDelay() {
    if (painted_ == session_.frameNumber()) return; // the same frame once more
    painted_ = session_.frameNumber();
    constexpr double kNewest = 0.1;
    const double delay = std::chrono::duration<double>(session_.frameAge()).count();
    // A frame that a server at rest drew before this window came says nothing about the delay.
    constexpr double kSecond = 1;
    if (delay > kSecond) return;
    paintDelay_ += (paintDelay_ > 0 ? kNewest : 1) * (delay - paintDelay_);
}

void FrameView::paintEvent(QPaintEvent* event) {
    QPainter painter(this);
    const QImage picture = shown();
    fades() ? drawFading(painter, event->rect()) : drawPicture(painter, picture, event->rect());
    if (!coloured_.isNull()) drawErrors(painter);
    if (!mark_.isNull() && !picture.isNull()) painter.drawImage(target(picture.size()), mark_);
    if (showsLive()) countDelay();
    for (const auto& drawMarks : drawMarks_) drawMarks(painter);
    words_ = stateText(session_);
    if (!words_.isEmpty() && !picture.isNull()) painter.fillRect(rect(), QColor(0, 0, 0, 90));
    drawWords(painter, rect(), words_);
    if (showOverlay_ && session_.live())
        drawOverlay(painter, rect(),
                    overlayText(session_.status(), picture.size(), still_, activity_, sharing_,
                                input_->hand() == Hand::Turns));
    if (told_.isEmpty()) return;
    const int line = 4 * painter.fontMetrics().height();
    drawWords(painter, QRect(0, height() - line, width(), line), told_);
}

void FrameView::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    // The first size is the window's, not the user's wish.
    if (event->oldSize().isValid() && isVisible()) resizeTimer_.start(kResizeRest);
}

} // namespace gui
