#include "gui/view/error_colours.h"

#include "gui/models/translated.h"

#include "common/frames/error_byte.h"

#include <QLocale>
#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>

namespace gui {

namespace {

constexpr int kBlock = 8; ///< as the errors are pooled
constexpr double kLowest = 0.25;

/// One for each octave from kLowest on.
constexpr std::array<QRgb, 7> kColours{0xff2c4fd6, 0xff1e9bd8, 0xff22b573, 0xff9fd43a,
                                       0xfff7d038, 0xfff08a24, 0xffe0252b};

/// Where the error lies in kColours, 0 to their end.
double placeOf(double error) {
    return std::clamp(std::log2(std::max(error, kLowest) / kLowest), 0.0,
                      static_cast<double>(kColours.size() - 1));
}

QRgb between(QRgb a, QRgb b, double t) {
    const auto mix = [t](int from, int to) { return static_cast<int>(std::lround(from + t * (to - from))); };
    return qRgb(mix(qRed(a), qRed(b)), mix(qGreen(a), qGreen(b)), mix(qBlue(a), qBlue(b)));
}

QRgb colourOf(double error) {
    const double place = placeOf(error);
    const auto below = std::min(static_cast<std::size_t>(place), kColours.size() - 2);
    return between(kColours.at(below), kColours.at(below + 1), place - static_cast<double>(below));
}

/// The colour of each byte, and how much of it is seen.
struct ErrorColour {
    QRgb colour;
    double opacity;
};

std::array<ErrorColour, 256> errorColours() {
    constexpr double kMaxOpacity = 0.75;
    std::array<ErrorColour, 256> colours{};
    for (std::size_t byte = 0; byte < colours.size(); ++byte) {
        const auto error = static_cast<double>(app::errorOfByte(static_cast<std::uint8_t>(byte)));
        colours.at(byte) = {colourOf(error), kMaxOpacity * std::clamp(error / kLowest - 1, 0.0, 1.0)};
    }
    return colours;
}

/// Means of the bytes around each pixel, geometric means of errors: that of a single block is rough.
QImage smoothed(const QImage& errors) {
    constexpr int kCell = 2 * kBlock;
    const QSize cells((errors.width() + kCell - 1) / kCell, (errors.height() + kCell - 1) / kCell);
    return errors.scaled(cells, Qt::IgnoreAspectRatio, Qt::SmoothTransformation)
        .scaled(errors.size(), Qt::IgnoreAspectRatio, Qt::SmoothTransformation)
        .convertToFormat(QImage::Format_Grayscale8);
}

/// The block whose mean square is largest, and its root.
struct WorstBlock {
    QRect pixels;
    double error = 0;
};

WorstBlock worstBlock(const QImage& errors) {
    WorstBlock worst;
    for (int top = 0; top < errors.height(); top += kBlock) {
        for (int left = 0; left < errors.width(); left += kBlock) {
            const QRect block = QRect(left, top, kBlock, kBlock).intersected(errors.rect());
            double sum = 0;
            for (int y = block.top(); y <= block.bottom(); ++y) {
                const uchar* const row = errors.constScanLine(y);
                for (int x = block.left(); x <= block.right(); ++x) {
                    const auto error = static_cast<double>(app::errorOfByte(row[x]));
                    sum += error * error;
                }
            }
            const double error = std::sqrt(sum / (block.width() * block.height()));
            if (error > worst.error) worst = {block, error};
        }
    }
    return worst;
}

QString codes(double error) { return QLocale().toString(error, 'g', 2); }

} // namespace

QImage colouredByErrors(const QImage& picture, const QImage& errors) {
    if (errors.isNull() || errors.size() != picture.size()) return {};
    static const std::array<ErrorColour, 256> kByByte = errorColours();
    QImage result(picture.size(), QImage::Format_RGB32);
    if (result.isNull()) return result;
    const QImage source = picture.convertToFormat(QImage::Format_RGB32), smooth = smoothed(errors);
    for (int y = 0; y < result.height(); ++y) {
        const auto* const from = reinterpret_cast<const QRgb*>(source.constScanLine(y));
        const uchar* const error = smooth.constScanLine(y);
        auto* const to = reinterpret_cast<QRgb*>(result.scanLine(y));
        for (int x = 0; x < result.width(); ++x) {
            const int grey = qGray(from[x]);
            const ErrorColour& colour = kByByte.at(error[x]);
            to[x] = between(qRgb(grey, grey, grey), colour.colour, colour.opacity);
        }
    }
    return result;
}

void drawErrorLegend(QPainter& painter, const QRect& area) {
    constexpr int kStep = 44, kMargin = 10, kHeight = 10;
    const QFontMetrics metrics(painter.font());
    const QString title = tr("error, of 255");
    const int width = kStep * static_cast<int>(kColours.size());
    const int left = area.right() - width - 2 * kMargin;
    const QRect box(left, area.bottom() - kHeight - 2 * metrics.height() - 3 * kMargin, width + kMargin,
                    kHeight + 2 * metrics.height() + 2 * kMargin);
    painter.fillRect(box, QColor(0, 0, 0, 150));
    painter.setPen(Qt::white);
    const QRect line(box.left(), box.top() + kMargin / 2, box.width(), metrics.height());
    painter.drawText(line, Qt::AlignCenter, title);
    for (std::size_t i = 0; i < kColours.size(); ++i) {
        const QRect cell(box.left() + kMargin / 2 + kStep * static_cast<int>(i), line.bottom() + kMargin / 2,
                         kStep, kHeight);
        painter.fillRect(cell, QColor::fromRgb(kColours.at(i)));
        painter.drawText(cell.translated(0, kHeight + 2).adjusted(0, 0, 0, metrics.height()),
                         Qt::AlignHCenter | Qt::AlignTop, codes(kLowest * std::exp2(static_cast<double>(i))));
    }
}

void drawLargestError(QPainter& painter, const QRectF& area, const QImage& errors) {
    const WorstBlock worst = worstBlock(errors);
    if (worst.error <= 0 || area.isEmpty()) return;
    const double across = area.width() / errors.width(), down = area.height() / errors.height();
    QRectF frame(area.left() + worst.pixels.left() * across, area.top() + worst.pixels.top() * down,
                 worst.pixels.width() * across, worst.pixels.height() * down);
    constexpr double kAround = 4;
    frame.adjust(-kAround, -kAround, kAround, kAround);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(Qt::black, 4));
    painter.drawRect(frame);
    painter.setPen(QPen(Qt::white, 2));
    painter.drawRect(frame);
    const QString words = tr("largest: ±%1").arg(codes(worst.error));
    const QFontMetrics metrics(painter.font());
    QRectF box(frame.right() + kAround, frame.top(), metrics.horizontalAdvance(words) + 2 * kAround,
               metrics.height() + kAround);
    if (box.right() > area.right()) box.moveRight(frame.left() - kAround);
    if (box.bottom() > area.bottom()) box.moveBottom(area.bottom());
    painter.fillRect(box, QColor(0, 0, 0, 150));
    painter.setPen(Qt::white);
    painter.drawText(box, Qt::AlignCenter, words);
}

} // namespace gui
