#include "gui/view/fade.h"

namespace gui {

namespace {

constexpr int kMilliseconds = 300;

} // namespace

Fade::Fade(QObject* parent) : QObject(parent) {
    animation_.setStartValue(0.0);
    animation_.setEndValue(1.0);
    animation_.setDuration(kMilliseconds);
    connect(&animation_, &QVariantAnimation::valueChanged, this, &Fade::stepped);
    connect(&animation_, &QVariantAnimation::finished, this, [this] {
        from_ = {};
        emit stepped();
    });
}

void Fade::begin(const QImage& from) {
    animation_.stop();
    from_ = from;
    if (active()) animation_.start();
}

void Fade::end() {
    animation_.stop();
    from_ = {};
}

double Fade::share() const { return active() ? animation_.currentValue().toDouble() : 1; }

} // namespace gui
