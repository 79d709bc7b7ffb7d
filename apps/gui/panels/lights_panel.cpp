#include "gui/panels/lights_panel.h"

#include "gui/models/plain_text.h"
#include "gui/panels/column_area.h"
#include "gui/panels/light_fields.h"
#include "gui/panels/sky_fields.h"

#include <QAction>
#include <QButtonGroup>
#include <QCheckBox>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QRadioButton>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace gui {

namespace {

constexpr int kId = Qt::UserRole;
constexpr int kComputed = 1'000'000, kNone = kComputed + 1; ///< behind the numbers of maps
constexpr int kFewest = 3, kMax = 8;                        ///< rows of the list that are seen

QGroupBox* addBox(const QString& title, QVBoxLayout& column) {
    auto* box = new QGroupBox(title);
    new QVBoxLayout(box);
    column.addWidget(box);
    return box;
}

} // namespace

LightsPanel::LightsPanel(QAction* marks, QAction* openMap, QWidget* parent)
    : QWidget(parent), list_(new QListWidget), copy_(new QPushButton(tr("Copy"))),
      remove_(new QPushButton(tr("Remove"))), fields_(new LightFields), sky_(new SkyFields),
      environmentList_(new QVBoxLayout), environments_(new QButtonGroup(this)),
      computed_(new QRadioButton(tr("Computed sky with a sun"))),
      none_(new QRadioButton(tr("No background"))) {
    auto* column = new QWidget;
    auto* groups = new QVBoxLayout(column);
    makeLights(*groups, marks);
    makeEnvironments(*groups, openMap);
    groups->addStretch(1);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(new ColumnArea(column));
    show(SceneState());
}

void LightsPanel::makeEnvironments(QVBoxLayout& column, QAction* openMap) {
    QGroupBox* box = addBox(tr("Surroundings"), column);
    auto* inside = static_cast<QVBoxLayout*>(box->layout());
    inside->addLayout(environmentList_);
    // One choice with the maps above.
    for (QRadioButton* button : {computed_, none_}) inside->addWidget(button);
    environments_->addButton(computed_, kComputed);
    environments_->addButton(none_, kNone);
    // clicked: by the user, not by us
    connect(environments_, &QButtonGroup::idClicked, this, [this](int id) {
        if (id == kComputed) return emit skyWanted();
        if (id == kNone) return emit noBackgroundWanted();
        emit environmentChosen(id);
    });
    auto* open = new QPushButton(tr("Environment map…"));
    open->setToolTip(plainTip(openMap->toolTip()));
    open->setEnabled(openMap->isEnabled());
    connect(open, &QPushButton::clicked, openMap, &QAction::trigger);
    connect(openMap, &QAction::changed, open, [open, openMap] { open->setEnabled(openMap->isEnabled()); });
    inside->addWidget(open);
    inside->addWidget(sky_);
}

void LightsPanel::makeLights(QVBoxLayout& column, QAction* marks) {
    QGroupBox* box = addBox(tr("Lights"), column);
    list_->setAccessibleName(tr("Lights"));
    list_->setUniformItemSizes(true);
    box->layout()->addWidget(list_);
    auto* add = new QPushButton(tr("Add"));
    add->setToolTip(tr("Add a light where you look"));
    auto* kinds = new QMenu(add);
    for (std::size_t i = 0; i < rtcore::kLightKinds; ++i) {
        QAction* kind = kinds->addAction(lightKindText(static_cast<rtcore::LightKind>(i)));
        connect(kind, &QAction::triggered, this,
                [this, i] { emit addWanted(std::string(rtcore::kLightTraits.at(i).name)); });
    }
    add->setMenu(kinds);
    copy_->setToolTip(tr("Add a light like the selected one, in its place"));
    remove_->setToolTip(tr("Remove the selected light"));
    auto* row = new QHBoxLayout;
    for (QPushButton* button : {add, copy_, remove_}) row->addWidget(button);
    static_cast<QVBoxLayout*>(box->layout())->addLayout(row);
    auto* shown = new QCheckBox(tr("Show lights"));
    shown->setToolTip(plainTip(marks->toolTip()));
    shown->setChecked(marks->isChecked());
    connect(shown, &QCheckBox::clicked, marks, &QAction::trigger);
    connect(marks, &QAction::toggled, shown, &QCheckBox::setChecked);
    box->layout()->addWidget(shown);
    box->layout()->addWidget(fields_);
    connect(list_, &QListWidget::itemChanged, this, [this](QListWidgetItem* item) { onItem(*item); });
    connect(list_, &QListWidget::currentItemChanged, this, [this](QListWidgetItem* item) {
        selected_ = item != nullptr ? item->data(kId).toInt() : 0;
        showSelected();
        emit lightSelected(selected_);
    });
    connect(fields_, &LightFields::edited, this, &LightsPanel::lightEdited);
    connect(copy_, &QPushButton::clicked, this, [this] { emit copyWanted(selected_); });
    connect(remove_, &QPushButton::clicked, this, [this] { emit removeWanted(selected_); });
}

QListWidgetItem* LightsPanel::light(int place) const { return list_->item(place); }
QAbstractButton* LightsPanel::environment(int number) const { return environments_->button(number); }
QAbstractButton& LightsPanel::computedSky() { return *computed_; }
QAbstractButton& LightsPanel::noBackground() { return *none_; }

void LightsPanel::onItem(QListWidgetItem& item) {
    emit lightSwitched(item.data(kId).toInt(), item.checkState() == Qt::Checked);
}

void LightsPanel::showLights(const QList<ShownLight>& lights) {
    const QSignalBlocker blocker(list_);
    while (list_->count() > lights.size()) delete list_->takeItem(list_->count() - 1);
    while (list_->count() < lights.size()) list_->addItem(QString());
    for (int i = 0; i < lights.size(); ++i) {
        QListWidgetItem* item = list_->item(i);
        const ShownLight& light = lights[i];
        item->setText(lightText(light));
        item->setData(kId, light.id);
        item->setCheckState(light.on ? Qt::Checked : Qt::Unchecked);
        item->setToolTip(plainTip(light.id <= 9 ? tr("Key: %1").arg(light.id) : QString()));
    }
    const int rows = std::clamp(list_->count(), kFewest, kMax);
    list_->setFixedHeight(rows * std::max(list_->sizeHintForRow(0), list_->fontMetrics().height() + 4) + 6);
}

void LightsPanel::showSelected() {
    const auto light = std::ranges::find(shown_, selected_, &ShownLight::id);
    const bool there = light != shown_.end();
    copy_->setEnabled(there);
    remove_->setEnabled(there);
    fields_->setVisible(there && light->description);
    if (there && light->description) fields_->show(*light, metresPerUnit_, origin_);
}

void LightsPanel::select(int id) {
    selected_ = id;
    const QSignalBlocker blocker(list_);
    const auto light = std::ranges::find(shown_, id, &ShownLight::id);
    list_->setCurrentRow(light != shown_.end() ? static_cast<int>(light - shown_.begin()) : -1);
    showSelected();
}

void LightsPanel::showEnvironments(const SceneState& state) {
    // The sky's own environment is the last one.
    const bool sky = state.sky && !state.sky->studio && !state.environments.isEmpty();
    const bool skyShown = sky && state.environments.last().on;
    const bool any = std::ranges::any_of(state.environments, &NamedSwitch::on);
    showMaps(sky ? state.environments.mid(0, state.environments.size() - 1) : state.environments);
    environments_->setExclusive(false); // none may be on
    computed_->setChecked(skyShown);
    none_->setChecked(!any);
    environments_->setExclusive(true);
}

void LightsPanel::showMaps(const QList<NamedSwitch>& maps) {
    while (maps_.size() > maps.size()) delete maps_.takeLast();
    while (maps_.size() < maps.size()) {
        auto* button = new QRadioButton;
        button->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed); // names may be long
        environmentList_->addWidget(button);
        environments_->addButton(button, static_cast<int>(maps_.size()));
        maps_.append(button);
    }
    environments_->setExclusive(false);
    for (qsizetype i = 0; i < maps.size(); ++i) {
        const QString number = QString::number(i + 1); // as on the keys
        QRadioButton* button = maps_[i];
        const QString name = maps[i].name.isEmpty() ? tr("Map %1").arg(number) : maps[i].name;
        button->setText(plainEntry(name));
        button->setAccessibleName(name);
        button->setToolTip(plainTip(i >= 9 ? QString() : tr("Keys: M and %1").arg(number)));
        button->setChecked(maps[i].on);
    }
    environments_->setExclusive(true);
}

void LightsPanel::show(const SceneState& state) {
    shown_ = state.lights;
    metresPerUnit_ = state.metresPerUnit;
    origin_ = state.origin;
    showLights(state.lights);
    showEnvironments(state);
    sky_->show(state);
    select(selected_);
}

} // namespace gui
