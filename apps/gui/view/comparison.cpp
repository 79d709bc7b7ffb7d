#include "gui/view/comparison.h"

#include "gui/view/frame_view.h"

#include <QLocale>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <utility>

namespace gui {

namespace {

using namespace std::chrono_literals;

constexpr auto kTurn = 700ms;
constexpr double kReach = 6;  ///< pixels from the divider at which it is grasped
constexpr int kMargin = 8;    ///< of a label, pixels
constexpr int kPadding = 5;   ///< the same within it
constexpr int kMaxTimes = 64; ///< as bright

enum class Side { Left, Right, Middle };

/// Words below the image's lower edge, on one side of `x`.
void drawLabel(QPainter& painter, const QRectF& area, double x, Side side, const QString& text) {
    const QFontMetricsF metrics(painter.font());
    QRectF box = metrics.boundingRect(text).adjusted(-kPadding, -kPadding, kPadding, kPadding);
    box.moveBottom(area.bottom() - kMargin);
    if (side == Side::Left) box.moveRight(x - kMargin);
    if (side == Side::Right) box.moveLeft(x + kMargin);
    if (side == Side::Middle) box.moveCenter({x, box.center().y()});
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(0, 0, 0, 170));
    painter.drawRoundedRect(box, kPadding, kPadding);
    painter.setPen(Qt::white);
    painter.drawText(box, Qt::AlignCenter, text);
}

} // namespace

ImageDifference differenceOf(const QImage& kept, const QImage& now) {
    const QImage a = kept.scaled(now.size(), Qt::IgnoreAspectRatio, Qt::SmoothTransformation)
                         .convertToFormat(QImage::Format_RGB32);
    const QImage b = now.convertToFormat(QImage::Format_RGB32);
    ImageDifference found{.image = QImage(now.size(), QImage::Format_RGB32)};
    qint64 sum = 0;
    const auto forEachPixel = [&](auto&& use) {
        for (int y = 0; y < b.height(); ++y) {
            const auto* const first = reinterpret_cast<const QRgb*>(a.constScanLine(y));
            const auto* const second = reinterpret_cast<const QRgb*>(b.constScanLine(y));
            auto* const to = reinterpret_cast<QRgb*>(found.image.scanLine(y));
            for (int x = 0; x < b.width(); ++x) {
                const auto apart = [&](int (*channel)(QRgb)) {
                    return std::abs(channel(first[x]) - channel(second[x]));
                };
                use(to[x], apart(qRed), apart(qGreen), apart(qBlue));
            }
        }
    };
    forEachPixel([&](QRgb&, int red, int green, int blue) {
        sum += red + green + blue;
        found.largest = std::max({found.largest, red, green, blue});
    });
    const double channels = 3.0 * b.width() * b.height();
    found.mean = channels > 0 ? static_cast<double>(sum) / channels : 0;
    found.times = found.largest > 0 ? std::clamp(255 / found.largest, 1, kMaxTimes) : 1;
    forEachPixel([&](QRgb& pixel, int red, int green, int blue) {
        pixel = qRgb(red * found.times, green * found.times, blue * found.times);
    });
    return found;
}

Comparison::Comparison(FrameView& view) : QObject(&view), view_(view) {
    blink_.setInterval(kTurn);
    connect(&blink_, &QTimer::timeout, this, [this] {
        showsKept_ = !showsKept_;
        view_.update();
    });
    view_.addMarks([this](QPainter& painter) { draw(painter); });
    view_.installEventFilter(this);
}

void Comparison::keep(const QImage& image) {
    kept_ = image.copy();
    view_.update();
}

void Comparison::show(CompareMode mode) {
    mode_ = kept_.isNull() ? CompareMode::Off : mode;
    showsKept_ = mode_ == CompareMode::Blink;
    if (mode_ == CompareMode::Blink)
        blink_.start();
    else
        blink_.stop();
    if (mode_ != CompareMode::Divider) {
        drags_ = false;
        showCursor(false);
    }
    if (mode_ != CompareMode::Difference) difference_ = {};
    view_.update();
}

bool Comparison::isAtDivider(const QPointF& position) const {
    const QRectF area = view_.pictureArea();
    return area.contains(position) &&
           std::abs(position.x() - (area.left() + divider_ * area.width())) <= kReach;
}

void Comparison::moveDivider(double x) {
    const QRectF area = view_.pictureArea();
    if (area.isEmpty()) return;
    divider_ = std::clamp((x - area.left()) / area.width(), 0.0, 1.0);
    view_.update();
}

void Comparison::showCursor(bool atDivider) {
    if (atDivider == cursorShown_) return;
    cursorShown_ = atDivider;
    atDivider ? view_.setCursor(Qt::SplitHCursor) : view_.unsetCursor();
}

/// The divider comes before what else a press in the image means.
bool Comparison::eventFilter(QObject* /*watched*/, QEvent* event) {
    if (mode_ != CompareMode::Divider) return false;
    const QEvent::Type type = event->type();
    if (type != QEvent::MouseMove && type != QEvent::MouseButtonPress && type != QEvent::MouseButtonRelease)
        return false;
    const auto& mouse = static_cast<const QMouseEvent&>(*event);
    if (type == QEvent::MouseButtonPress) {
        drags_ = mouse.button() == Qt::LeftButton && isAtDivider(mouse.position());
        return drags_;
    }
    if (type == QEvent::MouseButtonRelease) return std::exchange(drags_, false);
    if (drags_) moveDivider(mouse.position().x());
    if (mouse.buttons() == Qt::NoButton) showCursor(isAtDivider(mouse.position()));
    return drags_;
}

void Comparison::draw(QPainter& painter) {
    const QRectF area = view_.pictureArea();
    if (mode_ == CompareMode::Off || area.isEmpty()) return;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    if (mode_ == CompareMode::Divider) drawDivider(painter, area);
    if (mode_ == CompareMode::Difference) drawDifference(painter, area);
    if (mode_ == CompareMode::Blink) {
        if (showsKept_) painter.drawImage(area, kept_);
        drawLabel(painter, area, area.center().x(), Side::Middle, showsKept_ ? tr("kept") : tr("now"));
    }
    painter.restore();
}

void Comparison::drawDivider(QPainter& painter, const QRectF& area) const {
    const double x = area.left() + divider_ * area.width();
    painter.save();
    painter.setClipRect(QRectF(area.topLeft(), QPointF(x, area.bottom())), Qt::IntersectClip);
    painter.drawImage(area, kept_);
    painter.restore();
    painter.setPen(QPen(QColor(0, 0, 0, 120), 3));
    painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
    painter.setPen(QPen(Qt::white, 1));
    painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
    painter.setBrush(Qt::white);
    painter.setPen(QPen(QColor(0, 0, 0, 120), 1));
    painter.drawEllipse(QPointF(x, area.center().y()), kReach, kReach);
    drawLabel(painter, area, x, Side::Left, tr("kept"));
    drawLabel(painter, area, x, Side::Right, tr("now"));
}

void Comparison::drawDifference(QPainter& painter, const QRectF& area) {
    const QImage now = view_.shown();
    if (now.isNull()) return;
    if (difference_.image.isNull() || differenceOf_[0] != kept_.cacheKey() ||
        differenceOf_[1] != now.cacheKey()) {
        difference_ = differenceOf(kept_, now);
        differenceOf_[0] = kept_.cacheKey();
        differenceOf_[1] = now.cacheKey();
    }
    painter.drawImage(area, difference_.image);
    const QLocale locale;
    QString text = tr("Difference: mean %1, largest %2 of 255")
                       .arg(locale.toString(difference_.mean, 'f', 2), locale.toString(difference_.largest));
    if (difference_.times > 1)
        text = tr("%1; shown %2 times as bright").arg(text, locale.toString(difference_.times));
    drawLabel(painter, area, area.center().x(), Side::Middle, text);
}

} // namespace gui
