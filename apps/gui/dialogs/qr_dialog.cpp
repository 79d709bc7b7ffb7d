#include "gui/dialogs/qr_dialog.h"

#include "gui/models/plain_text.h"
#include "gui/view/plain_widgets.h"
#include "gui/view/qr_code.h"

#include <QDialogButtonBox>
#include <QVBoxLayout>

namespace gui {

QrDialog::QrDialog(const QString& title, const QString& link, QWidget* parent) : QDialog(parent) {
    constexpr int kModule = 6; // pixels
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(plainTitle(title));
    const QImage code = qrCode(link);
    auto* image = new PlainLabel;
    image->setPixmap(QPixmap::fromImage(code.scaled(kModule * code.size())));
    image->setAlignment(Qt::AlignCenter);
    image->setAccessibleName(tr("QR code: %1").arg(title));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
    auto* column = new QVBoxLayout(this);
    column->addWidget(image);
    column->addWidget(new PlainLabel(tr("The camera of a phone or a tablet opens the page by it.")));
    column->addWidget(buttons);
}

} // namespace gui
