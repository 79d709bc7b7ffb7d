#include "gui/panels/flights_panel.h"

#include "gui/models/plain_text.h"
#include "gui/panels/column_area.h"
#include "gui/panels/flight_keys.h"
#include "gui/panels/flight_player.h"
#include "gui/panels/value_box.h"

#include "common/commands/command_lines.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QGridLayout>
#include <QGroupBox>
#include <QHeaderView>
#include <QLocale>
#include <QPushButton>
#include <QShortcut>
#include <QSignalBlocker>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace gui {

namespace {

namespace command = app::command;
using rtcore::FlightTiming;

constexpr double kUsualSeconds = 10; ///< of turntables and flights through views
enum Column { NameColumn, SecondsColumn, KeysColumn };

QPushButton* flightButton(const QString& text, const QString& tip) {
    auto* button = new QPushButton(text);
    button->setToolTip(plainTip(tip));
    return button;
}

QGroupBox* flightGroup(const QString& title, QWidget* inside) {
    auto* box = new QGroupBox(title);
    auto* column = new QVBoxLayout(box);
    column->addWidget(inside);
    return box;
}

QString firstFree(const QString& pattern, const std::vector<ShownFlight>& all) {
    for (int number = 1;; ++number) {
        const QString name = pattern.arg(number);
        if (std::ranges::find(all, name, &ShownFlight::name) == all.end()) return name;
    }
}

} // namespace

FlightsPanel::FlightsPanel(QWidget* parent)
    : QWidget(parent), player_(new FlightPlayer), keys_(new FlightKeys) {
    makeList();
    makeButtons();
    auto* fields = new QWidget;
    auto* form = new QFormLayout(fields);
    form->setContentsMargins(0, 0, 0, 0);
    makeFields();
    form->addRow(tr("Seconds:"), seconds_);
    form->addRow(tr("Speed:"), timing_);
    form->addRow(QString(), closed_);
    auto* column = new QWidget;
    auto* rows = new QVBoxLayout(column);
    rows->addWidget(list_);
    rows->addWidget(buttonGrid());
    rows->addWidget(player_);
    rows->addWidget(flightGroup(tr("Flight"), fields));
    rows->addWidget(flightGroup(tr("Key frames"), keys_));
    rows->addStretch(1);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(new ColumnArea(column));
    listenToParts();
    show(SceneState());
}

void FlightsPanel::makeList() {
    constexpr int kRows = 5;
    list_ = new QTableWidget(0, 3);
    list_->setAccessibleName(tr("Flights"));
    list_->setHorizontalHeaderLabels({tr("Name"), tr("Seconds"), tr("Key frames")});
    list_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    list_->horizontalHeader()->setSectionResizeMode(NameColumn, QHeaderView::Stretch);
    list_->horizontalHeader()->setHighlightSections(false);
    list_->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    const int rowHeight = list_->fontMetrics().height() + 6;
    list_->verticalHeader()->setMinimumSectionSize(rowHeight);
    list_->verticalHeader()->setDefaultSectionSize(rowHeight);
    list_->verticalHeader()->hide();
    list_->setSelectionBehavior(QAbstractItemView::SelectRows);
    list_->setSelectionMode(QAbstractItemView::SingleSelection);
    list_->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::DoubleClicked);
    list_->setTabKeyNavigation(false);
    list_->setShowGrid(false);
    list_->setWordWrap(false);
    list_->setMinimumHeight((kRows + 1) * rowHeight);
    connect(list_, &QTableWidget::currentCellChanged, this, [this](int row) {
        if (row >= 0 && row < std::ssize(state_.flights))
            chosen_ = state_.flights[static_cast<std::size_t>(row)].name;
        showSelected();
    });
    // Not while the list is still busy with its editor.
    // A click below the rows leaves the selected one, which all else is about.
    const auto keep = [this] {
        if (list_->selectedItems().isEmpty() && flight() != nullptr) list_->selectRow(list_->currentRow());
    };
    connect(list_, &QTableWidget::itemSelectionChanged, this, keep, Qt::QueuedConnection);
    connect(list_, &QTableWidget::itemChanged, this, [this](const QTableWidgetItem* item) {
        if (item->column() != NameColumn) return;
        const auto later = [this, row = item->row(), text = item->text()] { rename(row, text); };
        QMetaObject::invokeMethod(this, later, Qt::QueuedConnection);
    });
    auto* key = new QShortcut(Qt::Key_Delete, list_, nullptr, nullptr, Qt::WidgetShortcut);
    key->setAutoRepeat(false); // a flight at a time
    connect(key, &QShortcut::activated, this, &FlightsPanel::remove);
}

void FlightsPanel::makeButtons() {
    new_ = flightButton(tr("New"), tr("Begin a flight at the current view; add key frames from other views"));
    turntable_ = flightButton(tr("Turntable"), tr("Once around what one orbits in 10 seconds"));
    through_ = flightButton(tr("Through the saved views"),
                            tr("Through all bookmarks of the scene, in their order, in 10 seconds"));
    remove_ = flightButton(tr("Remove"), tr("Remove the selected flight; also Del. Can be undone"));
    film_ = flightButton(tr("Film…"), tr("Render the selected flight as a film or images"));
    connect(new_, &QPushButton::clicked, this, [this] { emit keyWanted(newName(tr("Flight %1"))); });
    connect(turntable_, &QPushButton::clicked, this, [this] {
        emit wanted(command::flightTurntable(newName(tr("Turntable %1")).toStdString(), kUsualSeconds));
    });
    connect(through_, &QPushButton::clicked, this, [this] {
        emit wanted(command::flightThrough(newName(tr("Views %1")).toStdString(), kUsualSeconds));
    });
    connect(remove_, &QPushButton::clicked, this, &FlightsPanel::remove);
    connect(film_, &QPushButton::clicked, this, [this] { emit filmWanted(selected()); });
}

QWidget* FlightsPanel::buttonGrid() {
    auto* buttons = new QWidget;
    auto* grid = new QGridLayout(buttons);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->addWidget(new_, 0, 0);
    grid->addWidget(turntable_, 0, 1);
    grid->addWidget(through_, 1, 0, 1, 2);
    grid->addWidget(remove_, 2, 0);
    grid->addWidget(film_, 2, 1);
    return buttons;
}

void FlightsPanel::makeFields() {
    constexpr double kShortest = 0.01;
    seconds_ = new ValueBox(kShortest, rtcore::kMaxFlightSeconds);
    seconds_->setAccessibleName(tr("Seconds"));
    seconds_->setToolTip(plainTip(tr("How long the whole takes; times of key frames are stretched")));
    seconds_->setKeyboardTracking(false);
    timing_ = new QComboBox;
    timing_->setAccessibleName(tr("Speed"));
    timing_->addItems({tr("even"), tr("by the times of key frames")});
    timing_->setToolTip(plainTip(tr("One speed all the way, or through each key frame at its time")));
    closed_ = new QCheckBox(tr("Closed"));
    closed_->setToolTip(plainTip(tr("Go on from the last key frame to the first; at an even speed")));
    connect(seconds_, &ValueBox::valueChanged, this, [this](double seconds) {
        emit edited(QStringLiteral("flight seconds ") + selected(),
                    command::flightSeconds(selected().toStdString(), seconds));
    });
    connect(timing_, &QComboBox::activated, this, [this](int index) {
        const auto chosen = static_cast<FlightTiming>(index);
        if (flight() == nullptr || flight()->timing == chosen) return;
        const auto timing = rtcore::nameOf(chosen);
        emit wanted(command::flightTiming(selected().toStdString(), std::string(timing)));
    });
    connect(closed_, &QCheckBox::clicked, this,
            [this](bool on) { emit wanted(command::flightClosed(selected().toStdString(), on)); });
}

void FlightsPanel::listenToParts() {
    connect(player_, &FlightPlayer::goWanted, this, [this](double seconds, std::optional<bool> goesOn) {
        emit goWanted(selected(), seconds, goesOn);
    });
    connect(player_, &FlightPlayer::playWanted, this,
            [this](double from) { emit playWanted(selected(), from); });
    connect(player_, &FlightPlayer::stopWanted, this, &FlightsPanel::stopWanted);
    connect(keys_, &FlightKeys::goWanted, this, [this](double seconds) {
        player_->showSeconds(seconds);
        emit goWanted(selected(), seconds, false);
    });
    connect(keys_, &FlightKeys::addWanted, this, [this] { emit keyWanted(selected()); });
    connect(keys_, &FlightKeys::wanted, this, &FlightsPanel::wanted);
    connect(keys_, &FlightKeys::edited, this, &FlightsPanel::edited);
}

// --- Edits ---

QString FlightsPanel::newName(const QString& pattern) {
    chosen_ = firstFree(pattern, state_.flights);
    return chosen_;
}

// A turntable has one key frame.
void FlightsPanel::addKey() {
    const ShownFlight* one = flight();
    const bool takes = one != nullptr && !one->turntable;
    emit keyWanted(takes ? one->name : newName(tr("Flight %1")));
}

void FlightsPanel::remove() {
    if (flight() != nullptr) emit wanted(command::flightRemove(selected().toStdString()));
}

void FlightsPanel::rename(int row, const QString& text) {
    if (row >= std::ssize(state_.flights)) return;
    const QString before = state_.flights[static_cast<std::size_t>(row)].name, now = text.trimmed();
    if (now == before) return;
    if (now.isEmpty()) return showList();
    chosen_ = now;
    if (before == selected()) player_->rename(now);
    emit wanted(command::flightRename(before.toStdString(), now.toStdString()));
}

// --- What is shown ---

const ShownFlight* FlightsPanel::flight() const {
    const int row = list_->currentRow();
    const bool there = row >= 0 && row < std::ssize(state_.flights);
    return there ? &state_.flights[static_cast<std::size_t>(row)] : nullptr;
}

QString FlightsPanel::selected() const { return flight() != nullptr ? flight()->name : QString(); }

void FlightsPanel::select(const QString& name) {
    chosen_ = name;
    const auto found = std::ranges::find(state_.flights, name, &ShownFlight::name);
    if (found != state_.flights.end())
        list_->setCurrentCell(static_cast<int>(found - state_.flights.begin()), NameColumn);
}

void FlightsPanel::show(const SceneState& state) {
    const bool same = state.flights == state_.flights;
    state_ = state;
    through_->setEnabled(!state_.bookmarks.isEmpty());
    if (!same || list_->rowCount() == 0) showList();
    showSelected();
}

void FlightsPanel::refused() {
    chosen_ = selected();
    showList();
    showSelected();
}

void FlightsPanel::showList() {
    const QSignalBlocker quiet(list_);
    const int before = list_->currentRow();
    list_->setRowCount(static_cast<int>(state_.flights.size()));
    const auto text = [this](int row, Column column, const QString& shown, const QString& tip) {
        auto* item = new QTableWidgetItem(shown);
        if (column != NameColumn) {
            item->setFlags(item->flags() & ~Qt::ItemIsEditable);
            item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
        }
        item->setToolTip(plainTip(tip));
        list_->setItem(row, column, item);
    };
    int chosen = -1;
    for (int row = 0; const ShownFlight& each : state_.flights) {
        const QString keys = each.turntable ? tr("turntable") : QString::number(each.keyCount);
        text(row, NameColumn, each.name, each.name);
        text(row, SecondsColumn, QLocale().toString(each.seconds, 'g', 6), {});
        text(row, KeysColumn, keys, {});
        if (each.name == chosen_) chosen = row;
        ++row;
    }
    const int last = list_->rowCount() - 1;
    list_->setCurrentCell(chosen >= 0 ? chosen : std::min(std::max(before, 0), last), NameColumn);
}

void FlightsPanel::showSelected() {
    const ShownFlight* one = flight();
    const bool there = one != nullptr;
    player_->setFlight(one);
    keys_->show(there ? std::optional(*one) : std::nullopt);
    for (QWidget* each : std::initializer_list<QWidget*>{remove_, film_, seconds_, timing_})
        each->setEnabled(there);
    closed_->setEnabled(there && !one->turntable && one->timing == FlightTiming::Even);
    const QSignalBlocker quiet(seconds_);
    if (there) seconds_->showRounded(one->seconds);
    timing_->setCurrentIndex(there ? static_cast<int>(one->timing) : 0);
    closed_->setChecked(there && one->closed);
}

} // namespace gui
