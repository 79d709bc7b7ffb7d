#include "gui/dialogs/picture_dialog.h"

#include <QFileInfo>
#include <QGuiApplication>
#include <QPainter>
#include <QScreen>

namespace gui {

PictureDialog::PictureDialog(const QString& file, QWidget* parent) : QDialog(parent), picture_(file) {
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowFlag(Qt::WindowMaximizeButtonHint);
    setWindowTitle(
        tr("%1 – %2 × %3").arg(QFileInfo(file).fileName()).arg(picture_.width()).arg(picture_.height()));
    setAccessibleName(tr("Picture %1").arg(QFileInfo(file).fileName()));
    const QSize most = QGuiApplication::primaryScreen()->availableSize() * 3 / 4;
    QSize size = picture_.size() / devicePixelRatio();
    if (size.width() > most.width() || size.height() > most.height()) size.scale(most, Qt::KeepAspectRatio);
    constexpr QSize kLeast(200, 150);
    resize(size.expandedTo(kLeast));
}

void PictureDialog::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), palette().color(QPalette::Base));
    if (picture_.isNull()) {
        painter.drawText(rect(), Qt::AlignCenter, tr("This picture cannot be shown here."));
        return;
    }
    const QSize size = picture_.size().scaled(this->size(), Qt::KeepAspectRatio);
    QRect place(QPoint(), size);
    place.moveCenter(rect().center());
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(place, picture_);
}

} // namespace gui
