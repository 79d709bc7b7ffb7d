#include "gui/panels/setting_row.h"

#include "gui/models/plain_text.h"
#include "gui/models/scene_state.h"
#include "gui/models/setting_labels.h"
#include "gui/panels/value_box.h"
#include "gui/panels/value_slider.h"
#include "gui/view/plain_widgets.h"

#include "rtcore/settings/settings_table.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QStandardItemModel>
#include <QToolButton>

#include <algorithm>

namespace gui {

namespace {

using rtcore::Setting;
using rtcore::SettingType;

QString ofView(std::string_view from) {
    return QString::fromUtf8(from.data(), static_cast<qsizetype>(from.size()));
}

QString suffixOf(const Setting& setting) {
    return setting.unit.empty() ? QString() : QLatin1Char(' ') + settingUnit(setting.unit);
}

// A typed value counts when it is finished, not each digit.
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

} // namespace

SettingRow::SettingRow(const Setting& setting, const QString& label, QFormLayout& form, QObject* parent)
    : QObject(parent), name_(ofView(setting.name)),
      usual_(QString::fromStdString(rtcore::settingText(setting.defaultValue))),
      editor_(makeEditor(setting, label)), slider_(makeSlider(setting)), reset_(makeReset(setting)) {
    editor_->setObjectName(name_);
    editor_->setAccessibleName(fullName(setting));
    editor_->setAccessibleDescription(settingHelp(setting.help));
    editor_->setToolTip(settingTip(setting));
    editor_->setFocusPolicy(Qt::StrongFocus);
    editor_->installEventFilter(this);
    if (auto* line = editor_->findChild<QLineEdit*>()) line->installEventFilter(this);
    place(setting, label, form);
}

void SettingRow::place(const Setting& setting, const QString& label, QFormLayout& form) {
    auto* field = new QHBoxLayout;
    field->setSpacing(2);
    if (slider_ != nullptr) field->addWidget(slider_, 1);
    field->addWidget(editor_, 1);
    field->addWidget(reset_);
    if (setting.type == SettingType::Boolean) return form.addRow(field);
    auto* sign = new PlainLabel(label + QLatin1Char(':'));
    sign->setToolTip(settingTip(setting));
    sign->setBuddy(editor_);
    sign->installEventFilter(this);
    label_ = sign;
    form.addRow(sign, field);
}

QToolButton* SettingRow::makeReset(const Setting& setting) {
    auto* button = new QToolButton;
    button->setText(QStringLiteral("↺"));
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::TabFocus);
    button->setAccessibleName(tr("Default of %1").arg(fullName(setting)));
    button->setToolTip(plainTip(tr("Back to the default: %1").arg(settingValueText(setting, usual_))));
    QSizePolicy policy = button->sizePolicy();
    policy.setRetainSizeWhenHidden(true); // fields keep their width
    button->setSizePolicy(policy);
    connect(button, &QToolButton::clicked, this, [this] {
        editor_->setFocus(); // the button is about to hide
        goBack();
    });
    return button;
}

void SettingRow::goBack() { emit edited(name_, usual_); }

QWidget* SettingRow::makeEditor(const Setting& setting, const QString& label) {
    switch (setting.type) {
    case SettingType::Boolean: {
        auto* box = new QCheckBox(label);
        connect(box, &QCheckBox::toggled, this, [this](bool on) {
            emit edited(name_, on ? QStringLiteral("true") : QStringLiteral("false"));
        });
        return box;
    }
    case SettingType::Integer: {
        auto* box = tamed(new QSpinBox, setting);
        box->setRange(static_cast<int>(setting.minimum), static_cast<int>(setting.maximum));
        connect(box, &QSpinBox::valueChanged, this,
                [this](int value) { emit edited(name_, QString::number(value)); });
        return box;
    }
    case SettingType::Number: {
        auto* box = tamed(new ValueBox(setting.minimum, setting.maximum), setting);
        connect(box, &QDoubleSpinBox::valueChanged, this, [this](double value) {
            emit edited(name_, QString::fromStdString(rtcore::settingText(static_cast<float>(value))));
        });
        return box;
    }
    case SettingType::Choice:
        break;
    }
    auto* box = new QComboBox;
    for (const std::string_view choice : setting.choices) box->addItem(settingLabel(choice), ofView(choice));
    for (const std::string_view choice : setting.choices)
        if (!setting.liveChoice.empty() && choice != setting.liveChoice) disableItem(*box, ofView(choice));
    connect(box, &QComboBox::currentIndexChanged, this,
            [this, box] { emit edited(name_, box->currentData().toString()); });
    return box;
}

// It ends where pages do: few want more, and that may be typed.
ValueSlider* SettingRow::makeSlider(const Setting& setting) {
    constexpr double kMaxEven = 5000, kMaxFactor = 1e7;
    const bool number = setting.type == SettingType::Integer || setting.type == SettingType::Number;
    if (!number || isPictureSize(name_)) return nullptr;
    const double min = setting.minimum, max = std::min(setting.maximum, setting.browser.maximum);
    const bool even = max - min <= kMaxEven, byFactors = min > 0 && max / min <= kMaxFactor;
    if (!even && !byFactors) return nullptr;
    auto* slider = new ValueSlider(min, max, setting.type == SettingType::Integer);
    slider->setAccessibleName(fullName(setting));
    slider->setToolTip(settingTip(setting));
    slider->setFocusPolicy(Qt::StrongFocus);
    slider->installEventFilter(this);
    connect(slider, &ValueSlider::moved, this, [this](double value) {
        if (auto* whole = qobject_cast<QSpinBox*>(editor_)) whole->setValue(static_cast<int>(value));
        if (auto* real = qobject_cast<ValueBox*>(editor_)) real->setValue(value);
    });
    return slider;
}

void SettingRow::show(const QMap<QString, QString>& values) {
    const auto value = values.constFind(name_);
    const bool known = value != values.constEnd();
    editor_->setEnabled(known);
    if (slider_ != nullptr) slider_->setEnabled(known);
    if (known) showValue(*value);
    differs_ = known && *value != usual_ && !isPictureSize(name_);
    reset_->setVisible(differs_);
}

void SettingRow::showValue(const QString& value) {
    const QSignalBlocker quiet(editor_);
    if (slider_ != nullptr && !slider_->isSliderDown()) slider_->showValue(value.toDouble());
    if (auto* check = qobject_cast<QCheckBox*>(editor_)) {
        check->setChecked(value == QLatin1String("true"));
    } else if (auto* choice = qobject_cast<QComboBox*>(editor_)) {
        choice->setCurrentIndex(choice->findData(value));
    } else if (auto* whole = qobject_cast<QSpinBox*>(editor_)) {
        if (whole->value() == value.toInt()) return; // a text under way stays
        whole->setValue(value.toInt());
        if (whole->hasFocus()) whole->selectAll();
    } else if (auto* number = qobject_cast<ValueBox*>(editor_)) {
        if (number->value() == value.toDouble()) return;
        number->setValue(value.toDouble());
        if (number->hasFocus()) number->selectAll();
    }
}

// The wheel over a field scrolls the panel unless the field has the focus; Ctrl+Z takes the last change of
// the scene back, not the last letter.
bool SettingRow::eventFilter(QObject* watched, QEvent* event) {
    auto* widget = qobject_cast<QWidget*>(watched);
    if (widget == label_ && event->type() == QEvent::MouseButtonDblClick) {
        if (differs_) goBack();
        return true;
    }
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
    return QObject::eventFilter(watched, event);
}

} // namespace gui
