#include "gui/panels/material_fields.h"

#include "gui/panels/colour_button.h"
#include "gui/panels/value_box.h"

#include "rtcore/scene/material.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QPushButton>
#include <QSignalBlocker>

namespace gui {

namespace {

/// Without the digits that a float does not have.
double rounded(float value) {
    constexpr int kDigits = 6;
    return QString::number(static_cast<double>(value), 'g', kDigits).toDouble();
}

} // namespace

MaterialFields::MaterialFields(QWidget* parent)
    : QWidget(parent), textures_(new QCheckBox(tr("Textures"))), flip_(new QCheckBox(tr("Upside down"))),
      reset_(new QPushButton(tr("As in the file"))) {
    auto* form = new QFormLayout(this);
    form->setContentsMargins(0, 0, 0, 0);
    colour_ = addColour(QStringLiteral("diffuse"), tr("Colour"));
    addNumber(QStringLiteral("roughness"), tr("Roughness"), &MaterialState::roughness, 0, 1);
    addNumber(QStringLiteral("metallic"), tr("Metal"), &MaterialState::metallic, 0, 1);
    addNumber(QStringLiteral("coat"), tr("Varnish"), &MaterialState::coat, 0, 1);
    addNumber(QStringLiteral("coatRoughness"), tr("Its roughness"), &MaterialState::coatRoughness, 0, 1);
    addNumber(QStringLiteral("reflectivity"), tr("Mirror"), &MaterialState::reflectivity, 0, 1);
    addNumber(QStringLiteral("opacity"), tr("Opacity"), &MaterialState::opacity, 0, 1);
    tint_ = addColour(QStringLiteral("transmission"), tr("Glass colour"));
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

ColourButton* MaterialFields::addColour(const QString& key, const QString& text) {
    auto* button = new ColourButton(text);
    qobject_cast<QFormLayout*>(layout())->addRow(text, button);
    connect(button, &ColourButton::edited, this,
            [this, key](const std::array<float, 3>& linear) { emit colourEdited(key, linear); });
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
    colour_->show(state_.diffuse);
    tint_->show(state_.transmission);
    textures_->setEnabled(state_.textures.has_value());
    textures_->setChecked(state_.textures.value_or(false));
    flip_->setEnabled(state_.textures.value_or(false));
    flip_->setChecked(state_.flipTextures);
}

} // namespace gui
