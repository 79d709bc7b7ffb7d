#include "gui/panels/value_slider.h"

#include <QSignalBlocker>

#include <algorithm>
#include <cmath>

namespace gui {

namespace {

constexpr int kPositions = 500;
constexpr double kManyOrders = 1000;
constexpr int kDigits = 3; ///< as fine as a hand is

double withFewDigits(double value) { return QString::number(value, 'g', kDigits).toDouble(); }

} // namespace

ValueSlider::ValueSlider(double least, double most, bool whole, QWidget* parent)
    : QSlider(Qt::Horizontal, parent), least_(least), most_(most), whole_(whole),
      byFactors_(least > 0 && most / least >= kManyOrders) {
    constexpr int kLeastWide = 60, kPages = 10;
    const bool eachNumber = whole_ && !byFactors_;
    setRange(0, eachNumber ? static_cast<int>(most_ - least_) : kPositions);
    setPageStep(std::max(1, maximum() / kPages));
    setMinimumWidth(kLeastWide);
    connect(this, &QSlider::valueChanged, this, [this](int position) { emit moved(valueAt(position)); });
}

double ValueSlider::valueAt(int position) const {
    if (position <= 0) return least_;
    if (position >= maximum()) return most_;
    const double fraction = static_cast<double>(position) / maximum();
    const double value =
        byFactors_ ? least_ * std::pow(most_ / least_, fraction) : least_ + fraction * (most_ - least_);
    return whole_ ? std::round(value) : withFewDigits(value);
}

int ValueSlider::positionOf(double value) const {
    const double inside = std::clamp(value, least_, most_);
    const double fraction = byFactors_ ? std::log(inside / least_) / std::log(most_ / least_)
                                       : (inside - least_) / (most_ - least_);
    return static_cast<int>(std::lround(fraction * maximum()));
}

void ValueSlider::showValue(double value) {
    const QSignalBlocker quiet(this);
    setValue(positionOf(value));
}

} // namespace gui
