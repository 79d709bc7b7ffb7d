#include "gui/panels/settings_panel.h"

#include "gui/models/setting_labels.h"
#include "gui/panels/column_area.h"
#include "gui/panels/fold_box.h"
#include "gui/panels/quality_bar.h"
#include "gui/view/plain_widgets.h"

#include "rtcore/settings/main_settings.h"
#include "rtcore/settings/settings_table.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace gui {

namespace {

QString text(std::string_view from) {
    return QString::fromUtf8(from.data(), static_cast<qsizetype>(from.size()));
}

// The fields of all groups stand in one column.
void alignLabels(QWidget& column) {
    const QList<QFormLayout*> forms = column.findChildren<QFormLayout*>();
    QList<QWidget*> labels;
    for (const QFormLayout* form : forms)
        for (int row = 0; row < form->rowCount(); ++row)
            if (QLayoutItem* item = form->itemAt(row, QFormLayout::LabelRole)) labels.append(item->widget());
    int width = 0;
    for (const QWidget* label : labels) width = std::max(width, label->sizeHint().width());
    for (QWidget* label : labels) label->setMinimumWidth(width);
}

QFormLayout* formIn(QWidget& fields) {
    auto* form = new QFormLayout(&fields);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    return form;
}

} // namespace

SettingsPanel::SettingsPanel(QWidget* parent)
    : QWidget(parent), quality_(new QualityBar), defaults_(new QPushButton(tr("Defaults"))) {
    auto *column = new QWidget, *first = new QWidget, *groups = new QWidget;
    main_ = formIn(*first);
    main_->addRow(new PlainLabel(tr("Quality:")), quality_);
    auto* inside = new QVBoxLayout(groups);
    constexpr int kIndent = 10;
    inside->setContentsMargins(kIndent, 0, 0, 0);
    inside->setSpacing(2);
    advanced_ = new FoldBox(tr("Advanced"), groups);
    advanced_->setFolded(true);
    auto* all = new QVBoxLayout(column);
    all->setSpacing(2);
    all->addWidget(first);
    all->addWidget(advanced_);
    all->addStretch(1);
    addRows(*groups);
    alignLabels(*column);
    defaults_->setToolTip(tr("All settings but the size as they are without any file"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(new ColumnArea(column), 1);
    auto* foot = new QHBoxLayout;
    foot->setContentsMargins(9, 0, 9, 9);
    foot->addStretch(1);
    foot->addWidget(defaults_);
    layout->addLayout(foot);
    connect(defaults_, &QPushButton::clicked, this, &SettingsPanel::defaultsWanted);
    connect(quality_, &QualityBar::chosen, this, &SettingsPanel::qualityWanted);
    show({});
}

void SettingsPanel::addRows(QWidget& groups) {
    const auto add = [this](const rtcore::Setting& setting, const QString& label, QFormLayout& form) {
        auto* row = new SettingRow(setting, label, form, this);
        connect(row, &SettingRow::edited, this, &SettingsPanel::edited);
        rows_.insert(row->name(), row);
        return row;
    };
    for (const rtcore::MainSetting& each : rtcore::mainSettings())
        add(rtcore::requireSetting(each.name), mainSettingLabel(each), *main_);
    QHash<QString, QFormLayout*> forms;
    for (const rtcore::Setting& setting : rtcore::settingsTable()) {
        if (rtcore::findMainSetting(setting.name) != nullptr) continue;
        const QString key = text(setting.group);
        QFormLayout*& form = forms[key];
        if (form == nullptr) form = addGroup(key, settingGroup(setting.group), groups);
        rowsOf_[key].append(add(setting, settingLabel(setting.name), *form));
    }
}

QFormLayout* SettingsPanel::addGroup(const QString& key, const QString& title, QWidget& column) {
    auto* fields = new QWidget;
    QFormLayout* form = formIn(*fields);
    auto* group = new FoldBox(title, fields);
    column.layout()->addWidget(group);
    groups_.insert(key, group);
    connect(group, &FoldBox::foldedChanged, this, [this] { emit foldedChanged(folded()); });
    return form;
}

void SettingsPanel::addToMain(const QString& label, QWidget* field) {
    const QLayoutItem* first = main_->itemAt(0, QFormLayout::LabelRole);
    auto* sign = new PlainLabel(label);
    sign->setMinimumWidth(first->widget()->minimumWidth());
    sign->setBuddy(field);
    main_->addRow(sign, field);
}

QWidget* SettingsPanel::editor(const QString& name) const {
    const SettingRow* row = rows_.value(name);
    return row != nullptr ? row->editor() : nullptr;
}

QToolButton* SettingsPanel::resetButton(const QString& name) const {
    const SettingRow* row = rows_.value(name);
    return row != nullptr ? row->reset() : nullptr;
}

ValueSlider* SettingsPanel::slider(const QString& name) const {
    const SettingRow* row = rows_.value(name);
    return row != nullptr ? row->slider() : nullptr;
}

QStringList SettingsPanel::folded() const {
    QStringList keys;
    for (auto group = groups_.begin(); group != groups_.end(); ++group) {
        if ((*group)->folded()) keys.append(group.key());
    }
    keys.sort();
    return keys;
}

void SettingsPanel::setFolded(const QStringList& keys) {
    for (auto group = groups_.begin(); group != groups_.end(); ++group)
        (*group)->setFolded(keys.contains(group.key()));
}

void SettingsPanel::show(const QMap<QString, QString>& values) {
    for (SettingRow* row : rows_) row->show(values);
    bool any = false;
    for (auto group = groups_.begin(); group != groups_.end(); ++group) {
        const bool differs = std::ranges::any_of(rowsOf_.value(group.key()), &SettingRow::differs);
        (*group)->setMarked(differs);
        any |= differs;
    }
    advanced_->setMarked(any);
    quality_->show(values);
    defaults_->setEnabled(!values.isEmpty());
}

} // namespace gui
