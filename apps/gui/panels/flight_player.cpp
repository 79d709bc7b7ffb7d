#include "gui/panels/flight_player.h"

#include "gui/models/plain_text.h"
#include "gui/view/plain_widgets.h"

#include <QHBoxLayout>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QStyleOptionSlider>

#include <cmath>
#include <utility>
#include <vector>

namespace gui {

namespace {

constexpr double kThousand = 1000; // milliseconds

} // namespace

/// With a tick at each key frame. A click goes to where it is.
class TickedSlider : public QSlider {
  public:
    TickedSlider() : QSlider(Qt::Horizontal) {}
    void setTicks(const std::vector<int>& values) {
        ticks_ = values;
        update();
    }

  protected:
    // The press, and the drag that it may become, are one.
    void mousePressEvent(QMouseEvent* event) override {
        QStyleOptionSlider option;
        const QRect handle = handleOf(option);
        const int x = event->position().toPoint().x();
        if (event->button() == Qt::LeftButton && (x < handle.left() || x > handle.right())) {
            setSliderDown(true);
            setValue(QStyle::sliderValueFromPosition(minimum(), maximum(), x - handle.width() / 2,
                                                     width() - handle.width(), option.upsideDown));
        }
        QSlider::mousePressEvent(event);
    }
    void paintEvent(QPaintEvent* event) override {
        constexpr int kHigh = 4;
        QStyleOptionSlider option;
        const QRect handle = handleOf(option);
        const int room = width() - handle.width();
        QPainter painter(this);
        painter.setPen(palette().color(QPalette::WindowText));
        for (const int each : ticks_) {
            const int x = handle.width() / 2 + QStyle::sliderPositionFromValue(minimum(), maximum(), each,
                                                                               room, option.upsideDown);
            painter.drawLine(x, height() - kHigh, x, height() - 1);
        }
        painter.end();
        QSlider::paintEvent(event);
    }

  private:
    QRect handleOf(QStyleOptionSlider& option) const {
        initStyleOption(&option);
        return style()->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderHandle, this);
    }

    std::vector<int> ticks_;
};

FlightPlayer::FlightPlayer(QWidget* parent)
    : QWidget(parent), play_(new QPushButton), slider_(new TickedSlider), time_(new PlainLabel) {
    constexpr int kStep = 100, kPage = 1000, kMinWide = 60; // milliseconds; pixels
    slider_->setAccessibleName(tr("Time"));
    slider_->setToolTip(plainTip(tr("Look from where the flight is at that time")));
    slider_->setSingleStep(kStep);
    slider_->setPageStep(kPage);
    slider_->setMinimumWidth(kMinWide);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(play_);
    row->addWidget(slider_, 1);
    row->addWidget(time_);
    connect(play_, &QPushButton::clicked, this, &FlightPlayer::press);
    connect(slider_, &QSlider::sliderPressed, this, [this] { begun_ = false; });
    connect(slider_, &QSlider::valueChanged, this, &FlightPlayer::move);
    setPlaying(false);
    setFlight(nullptr);
}

void FlightPlayer::setFlight(const ShownFlight* flight) {
    const QSignalBlocker quiet(slider_);
    const QString name = flight != nullptr ? flight->name : QString();
    const bool another = std::exchange(name_, name) != name;
    if (another) slider_->setValue(0);
    slider_->setRange(0, flight != nullptr ? static_cast<int>(std::lround(flight->seconds * kThousand)) : 0);
    slider_->setTicks(flight != nullptr ? flight->keyTimes : std::vector<int>());
    setEnabled(flight != nullptr);
    showTime();
    if (another && playing_) emit stopWanted();
}

void FlightPlayer::move(int milliseconds) {
    showTime();
    const bool dragged = slider_->isSliderDown();
    const bool goesOn = std::exchange(begun_, dragged);
    emit goWanted(milliseconds / kThousand, dragged ? std::optional(goesOn) : std::nullopt);
}

QSlider& FlightPlayer::slider() { return *slider_; }
double FlightPlayer::seconds() const { return slider_->value() / kThousand; }

void FlightPlayer::showSeconds(double seconds) {
    const QSignalBlocker quiet(slider_);
    slider_->setValue(static_cast<int>(std::lround(seconds * kThousand)));
    showTime();
}

// As wide as the longest of its texts, so that the slider does not tremble.
void FlightPlayer::showTime() {
    const auto text = [](int milliseconds) {
        return tr("%1 s").arg(QLocale().toString(milliseconds / kThousand, 'f', 1));
    };
    time_->setMinimumWidth(time_->fontMetrics().horizontalAdvance(text(slider_->maximum())));
    time_->setText(text(slider_->value()));
}

void FlightPlayer::setPlaying(bool playing) {
    playing_ = playing;
    play_->setText(playing ? tr("Stop") : tr("Play"));
    play_->setToolTip(plainTip(playing ? tr("Stay where the flight is now")
                                       : tr("Show the flight in real time from here on; moving ends it")));
}

// From its end it begins again.
void FlightPlayer::press() {
    if (playing_) return emit stopWanted();
    emit playWanted(slider_->value() < slider_->maximum() ? seconds() : 0);
}

} // namespace gui
