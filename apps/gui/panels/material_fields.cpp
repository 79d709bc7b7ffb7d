#include "gui/panels/material_fields.h"

#include "gui/models/plain_text.h"
#include "gui/panels/value_box.h"

#include "rtcore/math/colour.h"
#include "rtcore/scene/material.h"

#include <QCheckBox>
#include <QColorDialog>
#include <QFormLayout>
#include <QPushButton>
#include <QSignalBlocker>

#include <algorithm>

namespace gui {

namespace {

QColor colourOf(const std::array<float, 3>& linear) {
    const auto code = [](float value) { return rtcore::srgbEncode(std::clamp(value, 0.0F, 1.0F)); };
    return QColor::fromRgbF(code(linear[0]), code(linear[1]), code(linear[2]));
}

std::array<float, 3> linearOf(const QColor& colour) {
    const auto light = [](double code) { return rtcore::srgbDecode(static_cast<float>(code)); };
    return {light(colour.redF()), light(colour.greenF()), light(colour.blueF())};
}

/// Without the digits that a float does not have.
double rounded(float value) {
    constexpr int kDigits = 6;
    return QString::number(static_cast<double>(value), 'g', kDigits).toDouble();
}

void paint(QPushButton& button, const std::array<float, 3>& linear) {
    QPixmap swatch(48, 16);
    swatch.fill(colourOf(linear));
    button.setIcon(QIcon(swatch));
    button.setText(colourOf(linear).name());
}

} // namespace

MaterialFields::MaterialFields(QWidget* parent)
    : QWidget(parent), textures_(new QCheckBox(tr("Textures"))), flip_(new QCheckBox(tr("Upside down"))),
      reset_(new QPushButton(tr("As in the file"))) {
    auto* form = new QFormLayout(this);
    form->setContentsMargins(0, 0, 0, 0);
    colour_ = addColour(QStringLiteral("diffuse"), tr("Colour"), &MaterialState::diffuse);
    addNumber(QStringLiteral("roughness"), tr("Roughness"), &MaterialState::roughness, 0, 1);
    addNumber(QStringLiteral("metallic"), tr("Metal"), &MaterialState::metallic, 0, 1);
    addNumber(QStringLiteral("coat"), tr("Varnish"), &MaterialState::coat, 0, 1);
    addNumber(QStringLiteral("coatRoughness"), tr("Its roughness"), &MaterialState::coatRoughness, 0, 1);
    addNumber(QStringLiteral("reflectivity"), tr("Mirror"), &MaterialState::reflectivity, 0, 1);
    addNumber(QStringLiteral("opacity"), tr("Opacity"), &MaterialState::opacity, 0, 1);
    tint_ = addColour(QStringLiteral("transmission"), tr("Glass colour"), &MaterialState::transmission);
    addNumber(QStringLiteral("indexOfRefraction"), tr("Refraction"), &MaterialState::indexOfRefraction, 1, 5);
    addNumber(QStringLiteral("priority"), tr("Priority"), &MaterialState::priority, 0,
              static_cast<double>(rtcore::kMaxPriority));
    number(QStringLiteral("priority"))->setWhole();
    form->addRow(textures_);
    form->addRow(flip_);
    form->addRow(reset_);
    reset_->setToolTip(tr("Reset this material"));
    connect(textures_, &QCheckBox::clicked, this,
            [this](bool on) { emit switched(QStringLiteral("textures"), on); });
    connect(flip_, &QCheckBox::clicked, this,
            [this](bool on) { emit switched(QStringLiteral("flipTextures"), on); });
    connect(reset_, &QPushButton::clicked, this, &MaterialFields::resetWanted);
    show(std::nullopt);
}

void MaterialFields::addNumber(const QString& key, const QString& text, float MaterialState::*value,
                               double minimum, double maximum) {
    auto* box = new ValueBox(minimum, maximum);
    box->setAccessibleName(text);
    box->setKeyboardTracking(false);
    qobject_cast<QFormLayout*>(layout())->addRow(text, box);
    connect(box, &QDoubleSpinBox::valueChanged, this,
            [this, key](double now) { emit numberEdited(key, now); });
    numbers_.append({key, box, value});
}

QPushButton* MaterialFields::addColour(const QString& key, const QString& text,
                                       std::array<float, 3> MaterialState::*value) {
    auto* button = new QPushButton;
    button->setAccessibleName(text);
    qobject_cast<QFormLayout*>(layout())->addRow(text, button);
    connect(button, &QPushButton::clicked, this, [this, key, text, value] {
        auto* dialog = new QColorDialog(colourOf(state_.*value), window());
        dialog->setAttribute(Qt::WA_DeleteOnClose);
        dialog->setWindowTitle(plainTitle(text));
        connect(dialog, &QColorDialog::currentColorChanged, this,
                [this, key](const QColor& colour) { emit colourEdited(key, linearOf(colour)); });
        const std::array<float, 3> before = state_.*value;
        connect(dialog, &QDialog::rejected, this, [this, key, before] { emit colourEdited(key, before); });
        dialog->open();
    });
    return button;
}

ValueBox* MaterialFields::number(const QString& key) const {
    for (const Number& each : numbers_) {
        if (each.key == key) return each.box;
    }
    return nullptr;
}

void MaterialFields::show(const std::optional<MaterialState>& material) {
    setEnabled(material.has_value());
    state_ = material.value_or(MaterialState{});
    for (const Number& each : numbers_) {
        const QSignalBlocker quiet(each.box);
        each.box->setValue(rounded(state_.*each.value));
    }
    paint(*colour_, state_.diffuse);
    paint(*tint_, state_.transmission);
    textures_->setEnabled(state_.textures.has_value());
    textures_->setChecked(state_.textures.value_or(false));
    flip_->setEnabled(state_.textures.value_or(false));
    flip_->setChecked(state_.flipTextures);
}

} // namespace gui
