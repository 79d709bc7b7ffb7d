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

ValueSlider::ValueSlider(double min, double max, bool whole, QWidget* parent)
    : QSlider(Qt::Horizontal, parent), min_(min), max_(max), whole_(whole),
      byFactors_(min > 0 && max / min >= kManyOrders) {
    constexpr int kMinWide = 60, kPages = 10;
    const bool eachNumber = whole_ && !byFactors_;
    setRange(0, eachNumber ? static_cast<int>(max_ - min_) : kPositions);
    setPageStep(std::max(1, maximum() / kPages));
    setMinimumWidth(kMinWide);
    connect(this, &QSlider::valueChanged, this, [this](int position) { emit moved(valueAt(position)); });
}

double ValueSlider::valueAt(int position) const {
    if (position <= 0) return min_;
    if (position >= maximum()) return max_;
    const double fraction = static_cast<double>(position) / maximum();
    const double value =
        byFactors_ ? min_ * std::pow(max_ / min_, fraction) : min_ + fraction * (max_ - min_);
    return whole_ ? std::round(value) : withFewDigits(value);
}

int ValueSlider::positionOf(double value) const {
    const double inside = std::clamp(value, min_, max_);
    const double fraction =
        byFactors_ ? std::log(inside / min_) / std::log(max_ / min_) : (inside - min_) / (max_ - min_);
    return static_cast<int>(std::lround(fraction * maximum()));
}

void ValueSlider::showValue(double value) {
    const QSignalBlocker quiet(this);
    setValue(positionOf(value));
}

} // namespace gui
