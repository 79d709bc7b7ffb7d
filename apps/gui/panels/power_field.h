/// A field for what a light gives off, in lumens or radiant watts; of a directional one what falls on a
/// surface, in lux or watts per square metre.
#pragma once

#include "rtcore/scene/light.h"

#include <QWidget>

#include <string>

class QComboBox;

namespace gui {

class ValueBox;

class PowerField : public QWidget {
    Q_OBJECT

  public:
    explicit PowerField(QWidget* parent = nullptr);

    /// Emits nothing. `power`: of all its directions, as scenes count it (rtcore/scene/light_power.h).
    void show(const rtcore::Light& light, double power, float metresPerUnit);
    using QWidget::show;

    ValueBox& value() { return *value_; }
    QComboBox& unit() { return *unit_; }

  signals:
    /// By the user: a value above 0, and its unit as the command `light power` has it.
    void edited(double value, const std::string& unit);

  private:
    void showValue();

    ValueBox* value_;
    QComboBox* unit_; ///< lumens or lux, then watts
    rtcore::Light light_;
    double power_ = 0;
    float metresPerUnit_ = 1;
    bool showing_ = false; ///< changes are not the user's
};

} // namespace gui
