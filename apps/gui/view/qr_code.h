/// QR codes, which the cameras of phones and tablets read.
#pragma once

#include <QImage>

class QString;

namespace gui {

/// Built with libqrencode.
bool hasQrCodes();

/// Black on white with its quiet margin, one pixel for each module. Null without libqrencode, and for texts
/// that are too long (about 2 kB).
QImage qrCode(const QString& text);

} // namespace gui
