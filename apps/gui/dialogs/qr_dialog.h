/// A link as a QR code, for a phone or a tablet.
#pragma once

#include <QDialog>

namespace gui {

class QrDialog : public QDialog {
    Q_OBJECT

  public:
    /// hasQrCodes() must be true. `title`: whose link it is.
    QrDialog(const QString& title, const QString& link, QWidget* parent = nullptr);
};

} // namespace gui
