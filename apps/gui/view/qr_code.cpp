#include "gui/view/qr_code.h"

#include <QString>

#ifdef RT_HAS_QRENCODE
#include <qrencode.h>

#include <memory>
#endif

namespace gui {

#ifdef RT_HAS_QRENCODE

bool hasQrCodes() { return true; }

QImage qrCode(const QString& text) {
    constexpr int kMargin = 4; // modules, as the standard wants
    const std::unique_ptr<QRcode, void (*)(QRcode*)> code(
        QRcode_encodeString(text.toUtf8().constData(), 0, QR_ECLEVEL_M, QR_MODE_8, 1), QRcode_free);
    if (code == nullptr) return {};
    const int width = code->width;
    QImage image(width + 2 * kMargin, width + 2 * kMargin, QImage::Format_Grayscale8);
    image.fill(Qt::white);
    for (int y = 0; y < width; ++y) {
        for (int x = 0; x < width; ++x) {
            if ((code->data[y * width + x] & 1) != 0)
                image.setPixelColor(x + kMargin, y + kMargin, Qt::black);
        }
    }
    return image;
}

#else

bool hasQrCodes() { return false; }
QImage qrCode(const QString&) { return {}; }

#endif

} // namespace gui
