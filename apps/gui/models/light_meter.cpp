#include "gui/models/light_meter.h"

#include <algorithm>
#include <utility>

namespace gui {

namespace {

constexpr int kGlancePaths = 1 << 9, kFirstPaths = 1 << 13, kMaxPaths = 1 << 19, kMorePaths = 4;
constexpr double kEnough = 0.005;

bool isExact(const std::optional<MeasuredNumber>& number) {
    return !number || number->relativeError() <= kEnough;
}

} // namespace

LightMeter::LightMeter(Send send, QObject* parent) : QObject(parent), send_(std::move(send)) {}

/// The answer that is to come is out of date.
void LightMeter::drop() {
    wanted_.reset();
    // The first question is answered at once, or refused since another client measures, which goes on.
    if (std::exchange(asked_, std::nullopt) && paths_ > kFirstPaths)
        send_(command::measureStop(), [](const Answer&) {});
}

void LightMeter::forget() {
    drop();
    showNone();
}

void LightMeter::showNone() {
    if (!reading_.luminance) return;
    reading_ = {};
    emit changed();
}

void LightMeter::measure(const QPointF& point) {
    wanted_ = point;
    paths_ = kFirstPaths;
    ask();
}

void LightMeter::glance(const QPointF& point) {
    if (busy_ && glances_) return;
    drop();
    if (busy_) return; // until what was stopped has ended
    wanted_ = point;
    paths_ = kGlancePaths;
    ask();
}

void LightMeter::ask() {
    if (busy_ || !wanted_) return;
    busy_ = true;
    glances_ = paths_ == kGlancePaths;
    asked_ = std::exchange(wanted_, std::nullopt);
    send_(command::measureLight(asked_->x(), asked_->y(), paths_),
          [this](const Answer& answer) { take(answer); });
}

void LightMeter::take(const Answer& answer) {
    busy_ = false;
    const std::optional<QPointF> point = std::exchange(asked_, std::nullopt);
    if (!point || (wanted_ && !glances_)) return ask(); // another point by now
    if (!answer.done) return showNone();                // another client measures
    reading_ = lightReadingOf(answer.text);
    const bool enough = glances_ || (isExact(reading_.illuminance) && isExact(reading_.luminance));
    if (!enough && paths_ < kMaxPaths) {
        paths_ *= kMorePaths;
        wanted_ = point;
    }
    emit changed();
    ask();
}

} // namespace gui
