#include "gui/panels/sections_panel.h"

#include "gui/models/plain_text.h"
#include "gui/panels/colour_button.h"
#include "gui/panels/column_area.h"
#include "gui/panels/value_box.h"
#include "gui/panels/value_slider.h"

#include "common/commands/command_lines.h"

#include "rtcore/scene/up_axis.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QGridLayout>
#include <QGroupBox>
#include <QListWidget>
#include <QLocale>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace gui {

namespace {

namespace command = app::command;
using rtcore::Vec3;

constexpr double kFarthest = 1e12;
constexpr float kOnAxis = 0.9999F; ///< cosine
constexpr int kPositionDigits = 5; ///< of positions, as ValueBox::showRounded() has them

Vec3 upOfScene(const QString& up) { return rtcore::axisNamed(up.toStdString()).value_or(Vec3{0, 1, 0}); }

/// "-z"; "y".
std::string nameOfAxis(Vec3 axis) {
    const std::string name(rtcore::axisName(axis));
    return name.starts_with('+') ? name.substr(1) : name;
}

double alongOf(Vec3 along, const rtcore::FilePoint& p) {
    return double{along.x} * p[0] + double{along.y} * p[1] + double{along.z} * p[2];
}

QString shortNumber(double value, int digits) {
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    return locale.toString(QString::number(value, 'g', digits).toDouble(), 'g',
                           QLocale::FloatingPointShortest);
}

QString metresSuffix() { return QStringLiteral(" m"); }

QGroupBox* groupIn(const QString& title, QVBoxLayout& column) {
    auto* box = new QGroupBox(title);
    new QVBoxLayout(box);
    column.addWidget(box);
    return box;
}

QVBoxLayout& insideOf(QGroupBox& box) { return *static_cast<QVBoxLayout*>(box.layout()); }

} // namespace

SectionSide sideOf(Vec3 normal, const QString& up) {
    const Vec3 n = normalize(normal), above = upOfScene(up);
    const Vec3 right = rtcore::rightOf(above), front = rtcore::frontOf(above);
    const std::array<std::pair<Vec3, QString>, 6> sides{{{above, SectionsPanel::tr("above %1")},
                                                         {-above, SectionsPanel::tr("below %1")},
                                                         {front, SectionsPanel::tr("in front of %1")},
                                                         {-front, SectionsPanel::tr("behind %1")},
                                                         {right, SectionsPanel::tr("right of %1")},
                                                         {-right, SectionsPanel::tr("left of %1")}}};
    for (const auto& [axis, text] : sides) {
        if (dot(axis, n) < kOnAxis) continue;
        const Vec3 along{std::fabs(axis.x), std::fabs(axis.y), std::fabs(axis.z)};
        return {text, QString::fromStdString(nameOfAxis(along)), along};
    }
    return {SectionsPanel::tr("beyond %1"), {}, n};
}

SectionsPanel::SectionsPanel(QWidget* parent) : QWidget(parent) {
    auto* column = new QWidget;
    auto* groups = new QVBoxLayout(column);
    addCuts(*groupIn(tr("Cut the model open"), *groups));
    QGroupBox* planes = groupIn(tr("Sections"), *groups);
    addList(*planes);
    addPosition(*planes);
    addStyle(*groupIn(tr("Light and caps"), *groups));
    groups->addStretch(1);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(new ColumnArea(column));
    show(SceneState());
}

QPushButton* SectionsPanel::button(const QString& text, const QString& tip) {
    auto* made = new QPushButton(text);
    made->setToolTip(plainTip(tip));
    return made;
}

void SectionsPanel::addCuts(QGroupBox& box) {
    above_ = button(tr("From above"), tr("Take the upper half of the model away"));
    front_ = button(tr("From the front"), tr("Take the front half of the model away"));
    right_ = button(tr("From the right"), tr("Take the right half of the model away"));
    here_ = button(tr("Here"), tr("Cut along the face in the middle of the image: what lies before it is "
                                  "taken away"));
    auto* grid = new QGridLayout;
    grid->addWidget(above_, 0, 0);
    grid->addWidget(front_, 0, 1);
    grid->addWidget(right_, 1, 0);
    grid->addWidget(here_, 1, 1);
    insideOf(box).addLayout(grid);
    connect(above_, &QPushButton::clicked, this, [this] { cutThrough(upOfScene(state_.up)); });
    connect(front_, &QPushButton::clicked, this,
            [this] { cutThrough(rtcore::frontOf(upOfScene(state_.up))); });
    connect(right_, &QPushButton::clicked, this,
            [this] { cutThrough(rtcore::rightOf(upOfScene(state_.up))); });
    connect(here_, &QPushButton::clicked, this, [this] { emit wanted(command::sectionHere(0.5, 0.5)); });
}

void SectionsPanel::cutThrough(Vec3 axis) { emit wanted(command::sectionThrough(nameOfAxis(axis))); }

void SectionsPanel::addList(QGroupBox& box) {
    list_ = new QListWidget;
    list_->setAccessibleName(tr("Sections"));
    list_->setUniformItemSizes(true);
    const int row = list_->fontMetrics().height() + 4;
    list_->setFixedHeight(static_cast<int>(rtcore::kMaxSectionPlanes) * row + 6);
    insideOf(box).addWidget(list_);
    turn_ = button(tr("Turn"), tr("Take the other side away"));
    remove_ = button(tr("Remove"), tr("Remove the selected section"));
    clear_ = button(tr("Remove all"), tr("The model is whole again"));
    auto* buttons = new QHBoxLayout;
    for (QPushButton* each : {turn_, remove_, clear_}) buttons->addWidget(each);
    insideOf(box).addLayout(buttons);
    connect(list_, &QListWidget::currentRowChanged, this, [this] {
        showPosition();
        enable();
        emit selectionChanged(selectedNumber());
    });
    connect(turn_, &QPushButton::clicked, this,
            [this] { emit wanted(command::sectionTurn(list_->currentRow() + 1)); });
    connect(remove_, &QPushButton::clicked, this,
            [this] { emit wanted(command::sectionRemove(list_->currentRow() + 1)); });
    connect(clear_, &QPushButton::clicked, this, [this] { emit wanted(command::sectionClear()); });
}

void SectionsPanel::addPosition(QGroupBox& box) {
    slider_ = new ValueSlider(0, 1, false); // through the model
    slider_->setAccessibleName(tr("Section through the model"));
    position_ = new ValueBox(-kFarthest, kFarthest);
    position_->setAccessibleName(tr("Position of the section"));
    position_->setToolTip(tr("In the coordinates of the model's file"));
    position_->setSuffix(metresSuffix());
    position_->setKeyboardTracking(false);
    auto* row = new QHBoxLayout;
    row->addWidget(slider_, 1);
    row->addWidget(position_, 1);
    insideOf(box).addLayout(row);
    connect(slider_, &ValueSlider::moved, this, [this](double fraction) {
        if (showing_ || selected() == nullptr) return;
        const Track track = trackOf(*selected());
        // A drag is one step, however long it rests.
        const bool drag = slider_->isSliderDown();
        moveTo(track.lo + fraction * (track.hi - track.lo),
               drag ? std::optional(std::exchange(dragged_, true)) : std::nullopt);
    });
    connect(slider_, &ValueSlider::sliderPressed, this, [this] { dragged_ = false; });
    connect(position_, &QDoubleSpinBox::valueChanged, this, [this](double metres) {
        if (!showing_) moveTo(metres / metresPerUnit(), {});
    });
}

void SectionsPanel::addStyle(QGroupBox& box) {
    light_ = new QComboBox;
    light_->setAccessibleName(tr("Light"));
    light_->addItems({tr("Rooms keep their light"), tr("Light falls in")});
    light_->setToolTip(tr("Whether light, too, passes where the model is taken away"));
    caps_ = new QComboBox;
    caps_->setAccessibleName(tr("Caps"));
    caps_->addItems({tr("Colours of materials"), tr("One colour"), tr("None")});
    caps_->setToolTip(tr("Areas that close the solids that are cut"));
    colour_ = new ColourButton(tr("Colour of caps"));
    hatching_ = new QCheckBox(tr("Hatching"));
    hatching_->setToolTip(tr("Lines across caps"));
    auto* form = new QFormLayout;
    form->addRow(tr("Light"), light_);
    form->addRow(tr("Caps"), caps_);
    form->addRow(tr("Colour"), colour_);
    form->addRow(hatching_);
    insideOf(box).addLayout(form);
    const auto word = [](const auto& names, int i) {
        return std::string(names.at(static_cast<std::size_t>(i)));
    };
    connect(light_, &QComboBox::activated, this,
            [this, word](int i) { emit wanted(command::sectionLight(word(rtcore::kSectionLights, i))); });
    connect(caps_, &QComboBox::activated, this,
            [this, word](int i) { emit wanted(command::sectionCaps(word(rtcore::kCapColours, i))); });
    connect(colour_, &ColourButton::edited, this, [this](const std::array<float, 3>& linear) {
        emit edited(QStringLiteral("section colour"), command::sectionColour(linear), {});
    });
    connect(hatching_, &QCheckBox::clicked, this,
            [this](bool on) { emit wanted(command::sectionHatching(on)); });
}

const rtcore::SectionPlane* SectionsPanel::selected() const {
    const auto& planes = state_.sections.planes;
    const int row = list_->currentRow();
    return row >= 0 && row < std::ssize(planes) ? &planes[static_cast<std::size_t>(row)] : nullptr;
}

SectionsPanel::Track SectionsPanel::trackOf(const rtcore::SectionPlane& plane) const {
    const Vec3 along = sideOf(plane.normal, state_.up).along;
    Track track{.along = along,
                .at = alongOf(along, state_.origin.inFile(plane.point)),
                .zero = alongOf(along, state_.origin.at)};
    track.lo = track.hi = track.at;
    if (state_.bounds.empty()) return track;
    const Vec3 half = state_.bounds.size() * 0.5F;
    const double middle = alongOf(along, state_.origin.inFile(state_.bounds.centre()));
    const double reach =
        static_cast<double>(dot(Vec3{std::fabs(along.x), std::fabs(along.y), std::fabs(along.z)}, half));
    track.lo = middle - reach;
    track.hi = middle + reach;
    return track;
}

// What is shown goes with the hand, before the server tells of it.
void SectionsPanel::moveTo(double position, std::optional<bool> goesOn) {
    if (selected() == nullptr) return;
    const int row = list_->currentRow();
    rtcore::SectionPlane& plane = state_.sections.planes[static_cast<std::size_t>(row)];
    const Track track = trackOf(plane);
    rtcore::FilePoint point = state_.origin.inFile(plane.point);
    for (std::size_t i = 0; i < point.size(); ++i)
        point.at(i) += double{track.along[static_cast<int>(i)]} * (position - track.at);
    plane.point = state_.origin.local(point);
    emit edited(stepAt(row + 1), command::sectionAt(row + 1, point), goesOn);
    showList();
    showPosition();
}

// Without the digits of its rounding to a float.
double SectionsPanel::metresPerUnit() const {
    return QString::number(static_cast<double>(state_.metresPerUnit), 'g', 7).toDouble();
}

QString SectionsPanel::nameOf(const rtcore::SectionPlane& plane) const {
    const SectionSide side = sideOf(plane.normal, state_.up);
    const Track track = trackOf(plane);
    const double rounded = QString::number(inMetres(track.at - track.zero), 'g', kPositionDigits).toDouble();
    const QString position = shortNumber(inMetres(track.zero) + rounded, 12) + metresSuffix();
    if (!side.coordinate.isEmpty()) return side.away.arg(side.coordinate + QStringLiteral(" = ") + position);
    QStringList numbers;
    for (int i = 0; i < 3; ++i) numbers << shortNumber(static_cast<double>(side.along[i]), 2);
    return side.away.arg(position) + QStringLiteral(" (") + numbers.join(QStringLiteral("; ")) +
           QLatin1Char(')');
}

void SectionsPanel::showList() {
    const QSignalBlocker quiet(list_);
    const auto& planes = state_.sections.planes;
    const int count = static_cast<int>(planes.size());
    const bool grew = count > list_->count();
    const int current = std::min(std::max(list_->currentRow(), 0), count - 1);
    while (list_->count() > count) delete list_->takeItem(list_->count() - 1);
    while (list_->count() < count) list_->addItem(QString());
    for (int i = 0; i < count; ++i)
        list_->item(i)->setText(
            QStringLiteral("%1  %2").arg(i + 1).arg(nameOf(planes[static_cast<std::size_t>(i)])));
    list_->setCurrentRow(grew ? count - 1 : current);
}

void SectionsPanel::showPosition() {
    const rtcore::SectionPlane* const plane = selected();
    if (plane == nullptr) return;
    const bool before = std::exchange(showing_, true);
    const Track track = trackOf(*plane);
    position_->setZero(inMetres(track.zero));
    position_->showRounded(inMetres(track.at));
    if (!slider_->isSliderDown() && track.hi > track.lo)
        slider_->showValue((track.at - track.lo) / (track.hi - track.lo));
    showing_ = before;
}

void SectionsPanel::showStyle() {
    const rtcore::SectionPlanes& sections = state_.sections;
    light_->setCurrentIndex(static_cast<int>(sections.light));
    caps_->setCurrentIndex(static_cast<int>(sections.caps.colours));
    const rtcore::Colour colour = sections.caps.colour;
    colour_->show({colour.r, colour.g, colour.b});
    hatching_->setChecked(sections.caps.hatched);
}

void SectionsPanel::enable() {
    const bool one = selected() != nullptr, any = !state_.sections.empty();
    const bool more = state_.sections.planes.size() < rtcore::kMaxSectionPlanes;
    for (QPushButton* each : {above_, front_, right_, here_}) each->setEnabled(more);
    for (QWidget* each : {static_cast<QWidget*>(turn_), static_cast<QWidget*>(remove_),
                          static_cast<QWidget*>(slider_), static_cast<QWidget*>(position_)})
        each->setEnabled(one);
    clear_->setEnabled(any);
    colour_->setEnabled(state_.sections.caps.colours == rtcore::CapColours::One);
    hatching_->setEnabled(state_.sections.caps.colours != rtcore::CapColours::None);
}

void SectionsPanel::select(int number) { list_->setCurrentRow(number - 1); }
int SectionsPanel::selectedNumber() const { return list_->currentRow() + 1; }

void SectionsPanel::show(const SceneState& state) {
    state_ = state;
    showList();
    showPosition();
    showStyle();
    enable();
}

} // namespace gui
