#include "gui/panels/colour_button.h"

#include "gui/models/plain_text.h"

#include "rtcore/math/colour.h"

#include <QColorDialog>

#include <algorithm>

namespace gui {

namespace {

QColor shownColour(const std::array<float, 3>& linear) {
    const auto code = [](float value) { return rtcore::srgbEncode(std::clamp(value, 0.0F, 1.0F)); };
    return QColor::fromRgbF(code(linear[0]), code(linear[1]), code(linear[2]));
}

std::array<float, 3> linearOf(const QColor& colour) {
    const auto light = [](double code) { return rtcore::srgbDecode(static_cast<float>(code)); };
    return {light(colour.redF()), light(colour.greenF()), light(colour.blueF())};
}

} // namespace

ColourButton::ColourButton(const QString& name, QWidget* parent) : QPushButton(parent) {
    setAccessibleName(name);
    connect(this, &QPushButton::clicked, this, &ColourButton::ask);
}

void ColourButton::show(const std::array<float, 3>& linear) {
    linear_ = linear;
    QPixmap swatch(48, 16);
    swatch.fill(shownColour(linear));
    setIcon(QIcon(swatch));
    setIconSize(swatch.size());
    setText(shownColour(linear).name());
}

void ColourButton::ask() {
    auto* dialog = new QColorDialog(shownColour(linear_), window());
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(plainTitle(accessibleName()));
    connect(dialog, &QColorDialog::currentColorChanged, this,
            [this](const QColor& colour) { emit edited(linearOf(colour)); });
    connect(dialog, &QDialog::rejected, this, [this, before = linear_] { emit edited(before); });
    dialog->open();
}

} // namespace gui
