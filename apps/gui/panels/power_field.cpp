#include "gui/panels/power_field.h"

#include "gui/panels/value_box.h"

#include "rtcore/scene/light_power.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QSignalBlocker>

namespace gui {

namespace {

constexpr double kMaxPower = 1e15;
constexpr int kLumens = 0, kWatts = 1; ///< of the units

} // namespace

PowerField::PowerField(QWidget* parent)
    : QWidget(parent), value_(new ValueBox(0, kMaxPower)), unit_(new QComboBox) {
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(value_, 1);
    layout->addWidget(unit_);
    unit_->setSizeAdjustPolicy(QComboBox::AdjustToContents); // which change
    unit_->addItems({QStringLiteral("lm"), QStringLiteral("W")});
    value_->setAccessibleName(tr("Power"));
    unit_->setAccessibleName(tr("Unit of the power"));
    unit_->setToolTip(tr("Lumens, or radiant watts of 683 lumens each"));
    connect(value_, &QDoubleSpinBox::valueChanged, this, [this](double value) {
        if (showing_ || !(value > 0)) return;
        const bool directional = !traitsOf(light_).position;
        emit edited(value, unit_->currentIndex() == kWatts ? "W" : directional ? "lx" : "lm");
    });
    connect(unit_, &QComboBox::currentIndexChanged, this, &PowerField::showValue);
}

void PowerField::show(const rtcore::Light& light, double power, float metresPerUnit) {
    light_ = light;
    power_ = power;
    metresPerUnit_ = metresPerUnit;
    const bool directional = !traitsOf(light).position;
    unit_->setItemText(kLumens, directional ? QStringLiteral("lx") : QStringLiteral("lm"));
    unit_->setItemText(kWatts, directional ? QStringLiteral("W/m²") : QStringLiteral("W"));
    showValue();
}

void PowerField::showValue() {
    showing_ = true;
    const double watts = rtcore::radiantWatts(light_, power_, metresPerUnit_);
    value_->showRounded(unit_->currentIndex() == kWatts ? watts : watts * rtcore::kLumensPerWatt);
    showing_ = false;
}

} // namespace gui
