#include "gui/panels/flight_keys.h"

#include "gui/models/plain_text.h"
#include "gui/panels/value_box.h"

#include "common/commands/command_lines.h"

#include <QFormLayout>
#include <QGridLayout>
#include <QListWidget>
#include <QLocale>
#include <QPushButton>
#include <QShortcut>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace gui {

namespace {

namespace command = app::command;

constexpr double kMillisecondsOfSecond = 1000;

QPushButton* keyButton(const QString& text, const QString& tip) {
    auto* button = new QPushButton(text);
    button->setToolTip(plainTip(tip));
    return button;
}

} // namespace

FlightKeys::FlightKeys(QWidget* parent) : QWidget(parent), list_(new QListWidget) {
    constexpr int kRows = 5;
    list_->setAccessibleName(tr("Key frames"));
    list_->setUniformItemSizes(true);
    list_->setMinimumHeight(kRows * (list_->fontMetrics().height() + 4));
    list_->setToolTip(plainTip(tr("Enter or a double click looks from there")));
    addButtons();
    time_ = new ValueBox(0, rtcore::kMaxFlightSeconds);
    time_->setAccessibleName(tr("Time of the key frame"));
    time_->setToolTip(plainTip(tr("When the flight comes through the selected key frame; of a flight whose "
                                  "key frames have times")));
    time_->setSuffix(tr(" s"));
    time_->setKeyboardTracking(false);
    auto* grid = new QGridLayout;
    grid->addWidget(add_, 0, 0);
    grid->addWidget(set_, 0, 1);
    grid->addWidget(up_, 1, 0);
    grid->addWidget(down_, 1, 1);
    grid->addWidget(remove_, 2, 0, 1, 2);
    auto* form = new QFormLayout;
    form->addRow(tr("At:"), time_);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(list_);
    column->addLayout(grid);
    column->addLayout(form);
    connect(list_, &QListWidget::currentRowChanged, this, &FlightKeys::enable);
    connect(list_, &QListWidget::itemActivated, this, &FlightKeys::go);
    connect(time_, &ValueBox::valueChanged, this, [this](double seconds) {
        const std::string name = flight_->name.toStdString();
        emit edited(QStringLiteral("flight key time ") + flight_->name,
                    command::flightKeyTime(name, selected() + 1, seconds));
    });
    show(std::nullopt);
}

void FlightKeys::addButtons() {
    add_ = keyButton(tr("Add"), tr("Let the flight end at the current view"));
    set_ = keyButton(tr("Replace"), tr("Let the selected key frame be the current view"));
    up_ = keyButton(tr("Earlier"), tr("Move the selected key frame before the one above it"));
    down_ = keyButton(tr("Later"), tr("Move the selected key frame behind the one below it"));
    remove_ =
        keyButton(tr("Remove"), tr("Remove the selected key frame; also Del. The last one goes with its "
                                   "flight"));
    connect(add_, &QPushButton::clicked, this, &FlightKeys::addWanted);
    connect(set_, &QPushButton::clicked, this,
            [this] { emit wanted(command::flightKeySet(flight_->name.toStdString(), selected() + 1)); });
    connect(up_, &QPushButton::clicked, this, [this] { move(-1); });
    connect(down_, &QPushButton::clicked, this, [this] { move(1); });
    connect(remove_, &QPushButton::clicked, this, &FlightKeys::remove);
    auto* key = new QShortcut(Qt::Key_Delete, list_, nullptr, nullptr, Qt::WidgetShortcut);
    key->setAutoRepeat(false); // a key frame at a time
    connect(key, &QShortcut::activated, this, &FlightKeys::remove);
}

int FlightKeys::selected() const {
    return flight_ && list_->currentRow() < flight_->keyCount ? list_->currentRow() : -1;
}

double FlightKeys::secondsOf(int key) const {
    return flight_->keyTimes[static_cast<std::size_t>(key)] / kMillisecondsOfSecond;
}

void FlightKeys::go() {
    if (selected() >= 0 && selected() < std::ssize(flight_->keyTimes)) emit goWanted(secondsOf(selected()));
}

void FlightKeys::move(int by) {
    const int from = selected(), to = from + by;
    if (from < 0 || to < 0 || to >= flight_->keyCount) return;
    emit wanted(command::flightKeyMove(flight_->name.toStdString(), from + 1, to + 1));
    list_->setCurrentRow(to);
}

void FlightKeys::remove() {
    if (selected() >= 0) emit wanted(command::flightKeyRemove(flight_->name.toStdString(), selected() + 1));
}

// One that was added is selected.
void FlightKeys::show(const std::optional<ShownFlight>& flight) {
    const bool same = flight_ && flight && flight_->name == flight->name;
    const int before = flight_ ? flight_->keyCount : 0;
    const int row = list_->currentRow();
    if (std::exchange(flight_, flight) != flight) showList();
    const int count = flight_ ? flight_->keyCount : 0;
    const bool added = same && count > before;
    const QSignalBlocker quiet(list_);
    list_->setCurrentRow(added ? count - 1 : same ? std::min(row, count - 1) : std::min(0, count - 1));
    enable();
}

void FlightKeys::showList() {
    const QSignalBlocker quiet(list_);
    list_->clear();
    const int known = flight_ ? static_cast<int>(std::ssize(flight_->keyTimes)) : 0;
    for (int i = 0; flight_ && i < flight_->keyCount; ++i) {
        const QString number = QString::number(i + 1);
        if (i >= known) {
            list_->addItem(number);
        } else {
            list_->addItem(tr("%1: at %2 s").arg(number, QLocale().toString(secondsOf(i), 'f', 1)));
        }
    }
}

void FlightKeys::enable() {
    const int row = selected();
    const int count = flight_ ? flight_->keyCount : 0;
    add_->setEnabled(flight_ && !flight_->turntable);
    set_->setEnabled(row >= 0);
    up_->setEnabled(row > 0);
    down_->setEnabled(row >= 0 && row + 1 < count);
    remove_->setEnabled(row >= 0);
    const bool timed = flight_ && flight_->timing == rtcore::FlightTiming::Times;
    time_->setEnabled(timed && row > 0);
    const QSignalBlocker quiet(time_);
    const bool known = row >= 0 && row < std::ssize(flight_->keyTimes);
    time_->showRounded(known ? secondsOf(row) : 0);
}

} // namespace gui
