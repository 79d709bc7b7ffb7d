#include "gui/models/picture_origin.h"

#include "gui/models/translated.h"

#include <QLocale>

namespace gui {

QString samplesText(int samples) { return tr("samples: %1").arg(QLocale().toString(samples)); }

QString originText(const PictureOrigin& origin) {
    const QString integrator = origin.paths ? tr("path tracing") : tr("Whitted ray tracing");
    if (origin.samples <= 0) return integrator;
    return tr("%1, samples per pixel: %2").arg(integrator, QLocale().toString(origin.samples));
}

void describe(QImage& picture, const PictureOrigin& origin) {
    picture.setText(QStringLiteral("Software"), QStringLiteral("rtsuite"));
    picture.setText(QStringLiteral("integrator"),
                    origin.paths ? QStringLiteral("path") : QStringLiteral("whitted"));
    picture.setText(QStringLiteral("samples"), QString::number(origin.samples));
}

} // namespace gui
