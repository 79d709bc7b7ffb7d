#include "gui/models/picture_origin.h"

#include "gui/models/translated.h"

#include "common/settings/image_texts.h"

#include "rtcore/post/error_text.h"

#include <QLocale>

namespace gui {

QString samplesText(int samples) { return tr("samples: %1").arg(QLocale().toString(samples)); }

QString errorText(const PictureOrigin& origin) {
    if (origin.error < 0) return {};
    const int digits = origin.error < 1 ? 2 : 1;
    return tr("±%1 of 255").arg(QLocale().toString(static_cast<double>(origin.error), 'f', digits));
}

QString originText(const PictureOrigin& origin) {
    const QString integrator = origin.paths ? tr("path tracing") : tr("Whitted ray tracing");
    if (origin.samples <= 0) return integrator;
    return tr("%1, samples per pixel: %2").arg(integrator, QLocale().toString(origin.samples));
}

void describe(QImage& picture, const PictureOrigin& origin) {
    const auto integrator = origin.paths ? rtcore::Integrator::Path : rtcore::Integrator::Whitted;
    for (const rtcore::ImageText& text : app::imageTexts(integrator, origin.samples))
        picture.setText(QString::fromStdString(text.name), QString::fromStdString(text.text));
    if (origin.error < 0) return;
    const std::string error = rtcore::errorText(origin.error, origin.largestError);
    picture.setText(QStringLiteral("denoising"), QString::fromStdString("denoised by a net: " + error));
}

} // namespace gui
