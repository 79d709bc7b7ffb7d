#include "gui/panels/measures_panel.h"

#include "gui/models/measure_texts.h"
#include "gui/models/plain_text.h"
#include "gui/panels/column_area.h"
#include "gui/view/plain_widgets.h"

#include "common/commands/command_lines.h"

#include <QComboBox>
#include <QFormLayout>
#include <QGridLayout>
#include <QGroupBox>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QShortcut>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QVBoxLayout>

#include <algorithm>

namespace gui {

namespace {

namespace command = app::command;
using rtcore::MeasureKind;

QGroupBox* measureGroup(const QString& title, QVBoxLayout& column) {
    auto* box = new QGroupBox(title);
    new QVBoxLayout(box);
    column.addWidget(box);
    return box;
}

QVBoxLayout& columnOf(QGroupBox& box) { return *static_cast<QVBoxLayout*>(box.layout()); }

} // namespace

MeasuresPanel::MeasuresPanel(QWidget* parent) : QWidget(parent) {
    auto* column = new QWidget;
    auto* groups = new QVBoxLayout(column);
    addTools(*measureGroup(tr("Measure"), *groups));
    addList(*measureGroup(tr("Measures"), *groups));
    addLabels(*measureGroup(tr("Labels"), *groups));
    groups->addStretch(1);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(new ColumnArea(column));
    show(SceneState());
}

void MeasuresPanel::addTools(QGroupBox& box) {
    const std::array<QString, rtcore::kMeasureKinds.size()> tips{
        tr("Between two points"),
        tr("Along three points or more; Enter ends it"),
        tr("At the second of three points"),
        tr("Of a point above the floor"),
        tr("Of a face, with all that is in its plane"),
        tr("Of a closed part")};
    auto* grid = new QGridLayout;
    for (std::size_t i = 0; i < tools_.size(); ++i) {
        const auto kind = static_cast<MeasureKind>(i);
        auto* button = new QPushButton(measureKindText(kind));
        button->setCheckable(true);
        button->setToolTip(plainTip(tips.at(i)));
        grid->addWidget(button, static_cast<int>(i / 2), static_cast<int>(i % 2));
        connect(button, &QPushButton::clicked, this,
                [this, kind](bool on) { emit toolChosen(on ? std::optional(kind) : std::nullopt); });
        tools_.at(i) = button;
    }
    columnOf(box).addLayout(grid);
    hint_ = new PlainLabel;
    hint_->setWordWrap(true);
    columnOf(box).addWidget(hint_);
}

void MeasuresPanel::addList(QGroupBox& box) {
    constexpr int kRows = 8;
    const auto button = [](const QString& text, const QString& tip) {
        auto* made = new QPushButton(text);
        made->setToolTip(plainTip(tip));
        return made;
    };
    list_ = new QListWidget;
    list_->setAccessibleName(tr("Measures"));
    list_->setUniformItemSizes(true);
    list_->setTextElideMode(Qt::ElideRight);
    list_->setMinimumHeight(kRows * (list_->fontMetrics().height() + 4));
    columnOf(box).addWidget(list_);
    name_ = new QLineEdit;
    name_->setAccessibleName(tr("Name"));
    name_->setPlaceholderText(tr("Name"));
    name_->setToolTip(tr("Stands in the label of the selected measure"));
    name_->setMaxLength(static_cast<int>(rtcore::kMaxMeasureName) / 4); // bytes of a character, at most
    columnOf(box).addWidget(name_);
    go_ = button(tr("Go there"), tr("Look at the selected measure; also Enter or a double click"));
    remove_ = button(tr("Remove"), tr("Remove the selected measure; also Del"));
    clear_ = button(tr("Remove all"), tr("Can be undone"));
    export_ = button(tr("Export…"), tr("Write all measures as a table, a .csv file"));
    auto* grid = new QGridLayout;
    grid->addWidget(go_, 0, 0);
    grid->addWidget(export_, 0, 1);
    grid->addWidget(remove_, 1, 0);
    grid->addWidget(clear_, 1, 1);
    columnOf(box).addLayout(grid);
    connect(list_, &QListWidget::currentRowChanged, this, [this] {
        showName();
        enable();
    });
    connect(list_, &QListWidget::itemActivated, this, [this] { emit goWanted(selected()); });
    connect(name_, &QLineEdit::editingFinished, this, &MeasuresPanel::rename);
    connect(go_, &QPushButton::clicked, this, [this] { emit goWanted(selected()); });
    connect(remove_, &QPushButton::clicked, this, &MeasuresPanel::remove);
    auto* key = new QShortcut(Qt::Key_Delete, list_, nullptr, nullptr, Qt::WidgetShortcut);
    key->setAutoRepeat(false); // a measure at a time
    connect(key, &QShortcut::activated, this, &MeasuresPanel::remove);
    connect(clear_, &QPushButton::clicked, this, [this] { emit wanted(command::measureRemoveAll()); });
    connect(export_, &QPushButton::clicked, this, &MeasuresPanel::exportWanted);
}

void MeasuresPanel::addLabels(QGroupBox& box) {
    unit_ = new QComboBox;
    unit_->setAccessibleName(tr("Unit"));
    for (const std::string_view name : rtcore::kLengthUnits)
        unit_->addItem(QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size())));
    decimals_ = new QSpinBox;
    decimals_->setAccessibleName(tr("Decimals"));
    decimals_->setRange(0, rtcore::kMaxMeasureDecimals);
    auto* form = new QFormLayout;
    form->addRow(tr("Unit"), unit_);
    form->addRow(tr("Decimals"), decimals_);
    columnOf(box).addLayout(form);
    connect(unit_, &QComboBox::activated, this, &MeasuresPanel::chooseUnit);
    connect(decimals_, &QSpinBox::valueChanged, this, [this] {
        if (!showing_) chooseUnit();
    });
}

void MeasuresPanel::chooseUnit() {
    const auto unit = rtcore::kLengthUnits.at(static_cast<std::size_t>(unit_->currentIndex()));
    emit wanted(command::measureUnit(std::string(unit), decimals_->value()));
}

void MeasuresPanel::remove() {
    if (selected() >= 0) emit wanted(command::measureRemove(selected() + 1));
}

void MeasuresPanel::rename() {
    if (showing_ || selected() < 0) return;
    const std::string name = name_->text().toStdString();
    if (name == state_.measures.all[static_cast<std::size_t>(selected())].name) return;
    emit wanted(command::measureName(selected() + 1, name));
}

int MeasuresPanel::selected() const {
    const int row = list_->currentRow();
    return row < std::ssize(state_.measures.all) ? row : -1;
}

void MeasuresPanel::setTool(std::optional<MeasureKind> kind) {
    for (std::size_t i = 0; i < tools_.size(); ++i)
        tools_.at(i)->setChecked(kind == static_cast<MeasureKind>(i));
}

void MeasuresPanel::setHint(const QString& hint) {
    hint_->setText(hint);
    hint_->setVisible(!hint.isEmpty());
}

void MeasuresPanel::show(const SceneState& state) {
    const bool same = state.measures == state_.measures && state.metresPerUnit == state_.metresPerUnit &&
                      list_->count() > 0;
    state_ = state;
    showing_ = true;
    if (!same) showList();
    if (!same || !name_->hasFocus()) showName();
    unit_->setCurrentIndex(static_cast<int>(state_.measures.unit));
    decimals_->setValue(state_.measures.decimals);
    showing_ = false;
    enable();
}

void MeasuresPanel::showList() {
    const QSignalBlocker quiet(list_);
    const int count = static_cast<int>(state_.measures.all.size()), before = list_->count();
    const int row = list_->currentRow();
    list_->clear();
    for (int i = 0; i < count; ++i) {
        const QString text = measureRow(state_, i);
        auto* item = new QListWidgetItem(text, list_);
        item->setToolTip(plainTip(text));
    }
    const int left = state_.measureCount - count;
    if (left > 0) (new QListWidgetItem(tr("%n more", nullptr, left), list_))->setFlags(Qt::NoItemFlags);
    list_->setCurrentRow(before >= 0 && count > before ? count - 1 : std::min(row, count - 1));
}

void MeasuresPanel::showName() {
    const QSignalBlocker quiet(name_);
    const int row = selected();
    name_->setText(row < 0 ? QString()
                           : QString::fromStdString(state_.measures.all[static_cast<std::size_t>(row)].name));
}

void MeasuresPanel::enable() {
    const bool one = selected() >= 0, any = !state_.measures.all.empty();
    for (QWidget* each : std::initializer_list<QWidget*>{name_, go_, remove_}) each->setEnabled(one);
    clear_->setEnabled(any);
    export_->setEnabled(any);
}

} // namespace gui
