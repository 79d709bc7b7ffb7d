/// An image coloured by the errors that are left in its pixels.
#pragma once

#include <QImage>

class QPainter;
class QRect;
class QRectF;

namespace gui {

/// `picture` in grey, and over it colours of the errors around each pixel, from a quarter of a code of 255,
/// which is not seen, to sixteen. `errors`: bytes (common/frames/error_byte.h), of the same size; else a null
/// image.
QImage colouredByErrors(const QImage& picture, const QImage& errors);

/// What the colours stand for, at the lower border of `area`.
void drawErrorLegend(QPainter& painter, const QRect& area);

/// A frame around the block of 8 x 8 pixels whose mean square is largest, and that error beside it. `area` is
/// where the image is.
void drawLargestError(QPainter& painter, const QRectF& area, const QImage& errors);

} // namespace gui
