#include "gui/panels/settings_panel.h"

#include "gui/models/plain_text.h"
#include "gui/models/scene_state.h"
#include "gui/models/setting_labels.h"
#include "gui/panels/column_area.h"
#include "gui/panels/fold_box.h"
#include "gui/panels/value_box.h"
#include "gui/view/plain_widgets.h"

#include "rtcore/settings/settings_table.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSet>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QStandardItemModel>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace gui {

namespace {

using rtcore::Setting;
using rtcore::SettingType;

QString text(std::string_view from) {
    return QString::fromUtf8(from.data(), static_cast<qsizetype>(from.size()));
}

QString suffixOf(const Setting& setting) {
    return setting.unit.empty() ? QString() : QLatin1Char(' ') + settingUnit(setting.unit);
}

// What is typed counts when it is finished, not each digit; the wheel scrolls the panel.
template <typename Box>
Box* tamed(Box* box, const Setting& setting) {
    box->setKeyboardTracking(false);
    box->setSuffix(suffixOf(setting));
    if (!setting.zero.empty()) box->setSpecialValueText(settingLabel(setting.zero)); // the minimum is 0
    return box;
}

// "on" of a group says nothing without it.
QString fullName(const Setting& setting) {
    const bool grouped = setting.name.find('.') != std::string_view::npos;
    const QString label = settingLabel(setting.name);
    return grouped ? settingGroup(setting.group) + QStringLiteral(": ") + label : label;
}

void disableItem(QComboBox& box, const QString& value) {
    const auto* items = qobject_cast<QStandardItemModel*>(box.model());
    if (items != nullptr) items->item(box.findData(value))->setEnabled(false);
}

// The fields of all groups stand in one column.
void alignLabels(QWidget& column) {
    const QList<QLabel*> labels = column.findChildren<QLabel*>();
    int width = 0;
    for (const QLabel* label : labels) width = std::max(width, label->sizeHint().width());
    for (QLabel* label : labels) label->setMinimumWidth(width);
}

} // namespace

SettingsPanel::SettingsPanel(QWidget* parent) : QWidget(parent), defaults_(new QPushButton(tr("Defaults"))) {
    auto* column = new QWidget;
    auto* groups = new QVBoxLayout(column);
    groups->setSpacing(2);
    QHash<QString, QFormLayout*> forms;
    for (const Setting& setting : rtcore::settingsTable()) {
        const QString key = text(setting.group);
        QFormLayout*& form = forms[key];
        if (form == nullptr) form = addGroup(key, settingGroup(setting.group), *column);
        addSetting(setting, key, *form);
    }
    alignLabels(*column);
    groups->addStretch(1);
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
    show({});
}

QFormLayout* SettingsPanel::addGroup(const QString& key, const QString& title, QWidget& column) {
    auto* fields = new QWidget;
    auto* form = new QFormLayout(fields);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    auto* group = new FoldBox(title, fields);
    column.layout()->addWidget(group);
    groups_.insert(key, group);
    connect(group, &FoldBox::foldedChanged, this, [this] { emit foldedChanged(folded()); });
    return form;
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

void SettingsPanel::addSetting(const Setting& setting, const QString& group, QFormLayout& form) {
    QWidget* editor = makeEditor(setting);
    const QString usual = QString::fromStdString(rtcore::settingText(setting.defaultValue));
    editor->setObjectName(text(setting.name));
    editor->setAccessibleName(fullName(setting));
    editor->setAccessibleDescription(settingHelp(setting.help));
    editor->setToolTip(settingTip(setting));
    editor->setFocusPolicy(Qt::StrongFocus);
    editor->installEventFilter(this);
    if (auto* line = editor->findChild<QLineEdit*>()) line->installEventFilter(this);
    QToolButton* reset = makeReset(setting, usual);
    rows_.insert(text(setting.name), {editor, reset, group, usual});
    auto* field = new QHBoxLayout;
    field->setSpacing(2);
    field->addWidget(editor, 1);
    field->addWidget(reset);
    if (setting.type == SettingType::Boolean) return form.addRow(field);
    auto* sign = new PlainLabel(settingLabel(setting.name) + QLatin1Char(':'));
    sign->setToolTip(settingTip(setting));
    sign->setBuddy(editor);
    form.addRow(sign, field);
}

QToolButton* SettingsPanel::makeReset(const Setting& setting, const QString& usual) {
    auto* button = new QToolButton;
    button->setText(QStringLiteral("↺"));
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::TabFocus);
    button->setAccessibleName(tr("Default of %1").arg(fullName(setting)));
    button->setToolTip(plainTip(tr("Back to the default: %1").arg(settingValueText(setting, usual))));
    QSizePolicy policy = button->sizePolicy();
    policy.setRetainSizeWhenHidden(true); // fields keep their width
    button->setSizePolicy(policy);
    connect(button, &QToolButton::clicked, this, [this, name = text(setting.name), usual] {
        editor(name)->setFocus(); // the button is about to hide
        emit edited(name, usual);
    });
    return button;
}

QWidget* SettingsPanel::makeEditor(const Setting& setting) {
    const QString name = text(setting.name);
    switch (setting.type) {
    case SettingType::Boolean: {
        auto* box = new QCheckBox(settingLabel(setting.name));
        connect(box, &QCheckBox::toggled, this, [this, name](bool on) {
            emit edited(name, on ? QStringLiteral("true") : QStringLiteral("false"));
        });
        return box;
    }
    case SettingType::Integer: {
        auto* box = tamed(new QSpinBox, setting);
        box->setRange(static_cast<int>(setting.minimum), static_cast<int>(setting.maximum));
        connect(box, &QSpinBox::valueChanged, this,
                [this, name](int value) { emit edited(name, QString::number(value)); });
        return box;
    }
    case SettingType::Number: {
        auto* box = tamed(new ValueBox(setting.minimum, setting.maximum), setting);
        connect(box, &QDoubleSpinBox::valueChanged, this, [this, name](double value) {
            emit edited(name, QString::fromStdString(rtcore::settingText(static_cast<float>(value))));
        });
        return box;
    }
    case SettingType::Choice:
        break;
    }
    auto* box = new QComboBox;
    for (const std::string_view choice : setting.choices) box->addItem(settingLabel(choice), text(choice));
    if (!setting.stillChoice.empty()) disableItem(*box, text(setting.stillChoice));
    connect(box, &QComboBox::currentIndexChanged, this,
            [this, name, box] { emit edited(name, box->currentData().toString()); });
    return box;
}

void SettingsPanel::show(const QMap<QString, QString>& values) {
    QSet<QString> changed;
    for (auto row = rows_.begin(); row != rows_.end(); ++row) {
        const auto value = values.constFind(row.key());
        const bool known = value != values.constEnd();
        row->editor->setEnabled(known);
        if (known) showValue(*row->editor, *value);
        const bool differs = known && *value != row->usual && !isPictureSize(row.key());
        row->reset->setVisible(differs);
        if (differs) changed.insert(row->group);
    }
    for (auto group = groups_.begin(); group != groups_.end(); ++group)
        (*group)->setMarked(changed.contains(group.key()));
    defaults_->setEnabled(!values.isEmpty());
}

void SettingsPanel::showValue(QWidget& editor, const QString& value) {
    const QSignalBlocker quiet(&editor);
    if (auto* check = qobject_cast<QCheckBox*>(&editor)) {
        check->setChecked(value == QLatin1String("true"));
    } else if (auto* choice = qobject_cast<QComboBox*>(&editor)) {
        choice->setCurrentIndex(choice->findData(value));
    } else if (auto* whole = qobject_cast<QSpinBox*>(&editor)) {
        if (whole->value() == value.toInt()) return; // what is being typed stays
        whole->setValue(value.toInt());
        if (whole->hasFocus()) whole->selectAll();
    } else if (auto* number = qobject_cast<ValueBox*>(&editor)) {
        if (number->value() == value.toDouble()) return;
        number->setValue(value.toDouble());
        if (number->hasFocus()) number->selectAll();
    }
}

// The wheel over a field scrolls the panel unless the field has the focus; Ctrl+Z takes the last change of
// the scene back, not the last letter.
bool SettingsPanel::eventFilter(QObject* watched, QEvent* event) {
    auto* widget = qobject_cast<QWidget*>(watched);
    if (event->type() == QEvent::Wheel && widget != nullptr && !widget->hasFocus()) {
        event->ignore();
        return true;
    }
    if (event->type() == QEvent::ShortcutOverride) {
        const auto* key = static_cast<const QKeyEvent*>(event);
        if (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)) {
            event->ignore();
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

} // namespace gui
