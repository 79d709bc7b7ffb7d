#include "gui/panels/sky_fields.h"

#include "gui/models/plain_text.h"
#include "gui/panels/typed_edit.h"
#include "gui/panels/value_box.h"

#include "common/commands/command_lines.h"

#include "rtcore/scene/up_axis.h"
#include "rtcore/sky/sun_position.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QPushButton>
#include <QSlider>

namespace gui {

namespace {

namespace command = app::command;

constexpr int kDay = 24 * 3600, kSliderStep = 300; ///< seconds
constexpr int kDirectionDigits = 3;                ///< as many as are seen
constexpr double kMaxStrength = 1e6;

rtcore::Vec3 upOf(const SceneState& state) {
    const auto found =
        std::find(rtcore::kAxisNames.begin(), rtcore::kAxisNames.end(), state.up.toStdString());
    const bool known = found != rtcore::kAxisNames.end();
    return known ? rtcore::kAxes.at(static_cast<std::size_t>(found - rtcore::kAxisNames.begin()))
                 : rtcore::Vec3{0, 1, 0};
}

std::array<float, 3> componentsOf(const rtcore::Vec3& v) { return {v.x, v.y, v.z}; }

void put(ValueBox* box, double value, int digits = 6) {
    const double shown = QString::number(value, 'g', digits).toDouble();
    if (box->value() != shown) box->setValue(shown);
}

} // namespace

SkyFields::SkyFields(QWidget* parent) : QWidget(parent), form_(new QFormLayout(this)) {
    form_->setContentsMargins(0, 0, 0, 0);
    form_->setRowWrapPolicy(QFormLayout::WrapLongRows);
    addMap();
    addSun();
    addTime();
    addPlace();
    addDirection();
    addAir();
    show(SceneState());
}

void SkyFields::send(const char* step, const std::string& line) {
    if (!showing_) emit edited(QString::fromLatin1(step), line);
}

ValueBox* SkyFields::number(const QString& label, double min, double max, const QString& unit) {
    auto* box = new ValueBox(min, max);
    box->setAccessibleName(label);
    box->setSuffix(unit);
    form_->addRow(label, box);
    return box;
}

void SkyFields::sends(ValueBox* box, const char* step, std::string (*line)(double)) {
    connect(box, &QDoubleSpinBox::valueChanged, this,
            [this, step, line](double value) { send(step, line(value)); });
}

void SkyFields::addMap() {
    mapRotation_ = number(tr("Turned by"), -360, 360, QStringLiteral("°"));
    mapRotation_->setToolTip(tr("Turns the environment map, to the right about the up axis"));
    sends(mapRotation_, "environment rotation", command::environmentRotation);
    mapStrength_ = number(tr("Brightness"), 0, kMaxStrength);
    mapStrength_->setToolTip(tr("How bright the environment map is; 1 is as its file says"));
    sends(mapStrength_, "environment strength", command::environmentStrength);
}

void SkyFields::addSun() {
    sun_ = new QComboBox;
    sun_->setAccessibleName(tr("Sun"));
    sun_->addItems({tr("By date and place"), tr("By direction")});
    form_->addRow(tr("Sun"), sun_);
    connect(sun_, &QComboBox::activated, this, &SkyFields::chooseSun);
}

void SkyFields::addTime() {
    hour_ = new QSlider(Qt::Horizontal);
    hour_->setAccessibleName(tr("Time of day"));
    hour_->setRange(0, kDay / kSliderStep);
    hour_->setPageStep(3600 / kSliderStep);
    hour_->setValue(kDay / 2 / kSliderStep);
    time_ = new TimeBox;
    time_->setAccessibleName(tr("Time"));
    time_->setDisplayFormat(QStringLiteral("HH:mm"));
    timeRow_ = new QWidget;
    auto* row = new QHBoxLayout(timeRow_);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(hour_, 1);
    row->addWidget(time_);
    form_->addRow(tr("Time"), timeRow_);
    connect(hour_, &QSlider::valueChanged, this,
            [this](int value) { send("sky hour", command::skyHour(value * kSliderStep / 3600.0)); });
    connect(time_, &QTimeEdit::timeChanged, this, [this](const QTime& time) {
        send("sky hour", command::skyHour(time.msecsSinceStartOfDay() / 3.6e6));
    });
    date_ = new DateBox;
    date_->setAccessibleName(tr("Date"));
    date_->setCalendarPopup(true);
    date_->setDisplayFormat(QStringLiteral("yyyy-MM-dd"));
    date_->setDateRange({1800, 1, 1}, {2200, 12, 31});
    form_->addRow(tr("Date"), date_);
    connect(date_, &QDateEdit::dateChanged, this, [this](const QDate& date) {
        send("sky date", command::skyDate(date.toString(Qt::ISODate).toStdString()));
    });
}

void SkyFields::addPlace() {
    const QString degrees = QStringLiteral("°");
    latitude_ = number(tr("Latitude"), -90, 90, degrees);
    latitude_->setToolTip(tr("Degrees north; negative in the south"));
    longitude_ = number(tr("Longitude"), -180, 180, degrees);
    longitude_->setToolTip(tr("Degrees east; negative in the west"));
    zone_ = number(tr("Time zone"), -15, 15, QStringLiteral(" h"));
    zone_->setToolTip(tr("What the clock is ahead of universal time"));
    for (ValueBox* box : {latitude_, longitude_, zone_})
        connect(box, &QDoubleSpinBox::valueChanged, this, &SkyFields::sendPlace);
    north_ = number(tr("North"), -360, 360, degrees);
    north_->setToolTip(tr("Where north is in the scene: from straight ahead to the right"));
    sends(north_, "sky north", command::skyNorth);
}

void SkyFields::addDirection() {
    directionRow_ = new QWidget;
    auto* row = new QHBoxLayout(directionRow_);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    constexpr std::array<char16_t, 3> kNames{u'x', u'y', u'z'};
    for (std::size_t i = 0; i < direction_.size(); ++i) {
        direction_.at(i) = new ValueBox(-1e9, 1e9);
        direction_.at(i)->setAccessibleName(tr("Direction to the sun") + QLatin1Char(' ') +
                                            QChar(kNames.at(i)));
        direction_.at(i)->setToolTip(plainTip(direction_.at(i)->accessibleName()));
        direction_.at(i)->setMinimumWidth(48);
        direction_.at(i)->setButtonSymbols(QAbstractSpinBox::NoButtons);
        row->addWidget(direction_.at(i), 1);
        connect(direction_.at(i), &QDoubleSpinBox::valueChanged, this, &SkyFields::sendDirection);
    }
    form_->addRow(tr("Sun direction"), directionRow_);
    auto* ahead = new QPushButton(tr("Along view"));
    ahead->setToolTip(tr("Put the sun where the camera looks"));
    connect(ahead, &QPushButton::clicked, this, &SkyFields::sunAheadWanted);
    aheadRow_ = ahead;
    form_->addRow({}, aheadRow_);
}

void SkyFields::addAir() {
    turbidity_ = number(tr("Haze"), rtcore::kMinTurbidity, rtcore::kMaxTurbidity);
    turbidity_->setToolTip(tr("2 very clear, 3 clear, 6 hazy, 10 thick"));
    sends(turbidity_, "sky turbidity", command::skyTurbidity);
    strength_ = number(tr("Strength"), 0, kMaxStrength);
    sends(strength_, "sky strength", command::skyStrength);
    ground_ = new QCheckBox(tr("Ground plane"));
    ground_->setToolTip(tr("A wide ground below the model"));
    form_->addRow(ground_);
    connect(ground_, &QCheckBox::clicked, this,
            [this](bool on) { send("sky ground", command::skyGround(on)); });
    haze_ = new QCheckBox(tr("White horizon"));
    haze_->setToolTip(tr("Haze at the horizon, into which a light ground fades"));
    form_->addRow(haze_);
    connect(haze_, &QCheckBox::clicked, this, [this](bool on) { send("sky haze", command::skyHaze(on)); });
}

void SkyFields::sendPlace() {
    send("sky place", command::skyPlace(latitude_->value(), longitude_->value(), zone_->value()));
}

// The components that are not edited stay to the last bit.
void SkyFields::sendDirection() {
    if (showing_ || !state_.sky) return;
    std::array<float, 3> to = componentsOf(state_.sky->direction);
    for (std::size_t i = 0; i < to.size(); ++i)
        if (direction_.at(i) == sender()) to.at(i) = static_cast<float>(direction_.at(i)->value());
    if (to == std::array<float, 3>{}) return;
    state_.sky->direction = {to[0], to[1], to[2]};
    send("sky direction", command::skyDirection(to));
}

// The sun stays where it is until it is moved.
void SkyFields::chooseSun(int by) {
    if (!state_.sky || (by == Date) == state_.sky->date.has_value()) return;
    if (by == Date) return send("sky hour", command::skyHour(hour_->value() * kSliderStep / 3600.0));
    send("sky direction", command::skyDirection(componentsOf(sunDirection(*state_.sky, upOf(state_)))));
}

void SkyFields::showSky(const rtcore::Sky& sky) {
    sun_->setCurrentIndex(sky.date ? Date : Direction);
    if (sky.date) {
        const QTime time = QTime::fromMSecsSinceStartOfDay(std::min(sky.date->second, kDay - 1) * 1000);
        if (hour_->value() != sky.date->second / kSliderStep) hour_->setValue(sky.date->second / kSliderStep);
        if (time_->time().hour() != time.hour() || time_->time().minute() != time.minute())
            time_->setTime(time);
        const QDate date(sky.date->year, sky.date->month, sky.date->day);
        if (date_->date() != date) date_->setDate(date);
        put(latitude_, sky.date->latitude);
        put(longitude_, sky.date->longitude);
        put(zone_, sky.date->timeZone);
    }
    for (std::size_t i = 0; i < direction_.size(); ++i)
        put(direction_.at(i), static_cast<double>(componentsOf(sky.direction).at(i)), kDirectionDigits);
    put(north_, static_cast<double>(sky.north));
    put(turbidity_, static_cast<double>(sky.turbidity));
    put(strength_, static_cast<double>(sky.strength));
    ground_->setChecked(sky.ground);
    haze_->setChecked(sky.haze);
}

void SkyFields::showRows() {
    const bool any = state_.sky.has_value(), sky = any && !state_.sky->studio, date = sky && state_.sky->date,
               map = state_.map.has_value();
    for (QWidget* row : {static_cast<QWidget*>(mapRotation_), static_cast<QWidget*>(mapStrength_)})
        form_->setRowVisible(row, map);
    for (QWidget* row :
         {static_cast<QWidget*>(sun_), static_cast<QWidget*>(turbidity_), static_cast<QWidget*>(haze_)})
        form_->setRowVisible(row, sky);
    for (QWidget* row : {static_cast<QWidget*>(strength_), static_cast<QWidget*>(ground_)})
        form_->setRowVisible(row, any);
    strength_->setToolTip(sky ? tr("How bright sun and sky are; 1 is as in nature")
                              : tr("How bright the walls of the studio are"));
    for (QWidget* row :
         {timeRow_, static_cast<QWidget*>(date_), static_cast<QWidget*>(latitude_),
          static_cast<QWidget*>(longitude_), static_cast<QWidget*>(zone_), static_cast<QWidget*>(north_)})
        form_->setRowVisible(row, date);
    for (QWidget* row : {directionRow_, aheadRow_}) form_->setRowVisible(row, sky && !date);
}

void SkyFields::show(const SceneState& state) {
    state_ = state;
    showing_ = true;
    if (state.sky) showSky(*state.sky);
    if (state.map) {
        put(mapRotation_, static_cast<double>(state.map->rotation));
        put(mapStrength_, static_cast<double>(state.map->strength));
    }
    showRows();
    showing_ = false;
}

} // namespace gui
