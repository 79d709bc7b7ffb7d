#include "gui/panels/quality_bar.h"

#include "gui/models/plain_text.h"
#include "gui/models/setting_labels.h"
#include "gui/view/plain_widgets.h"

#include "rtcore/settings/quality.h"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QPushButton>

#include <algorithm>
#include <string>

namespace gui {

namespace {

using rtcore::Quality;
using rtcore::QualityRow;

QString inQt(std::string_view text) {
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

/// -1: it is none of them.
int qualityOf(const QMap<QString, QString>& values) {
    for (int step = 0; step < static_cast<int>(rtcore::kQualityNames.size()); ++step) {
        const auto quality = static_cast<Quality>(step);
        if (std::ranges::all_of(rtcore::qualityTable(), [&](const QualityRow& row) {
                return values.value(inQt(row.setting)) == inQt(row.of(quality));
            }))
            return step;
    }
    return -1;
}

/// The settings of a quality, a line each: "Anti-aliasing: 3".
QString tipOf(Quality quality) {
    QStringList parts;
    for (const QualityRow& row : rtcore::qualityTable()) {
        const rtcore::Setting& setting = rtcore::requireSetting(row.setting);
        const bool grouped = row.setting.find('.') != std::string_view::npos;
        const QString label = grouped ? settingGroup(setting.group) + QLatin1Char(' ') : QString();
        parts.append(
            QStringLiteral("%1%2: %3")
                .arg(label, settingLabel(row.setting), settingValueText(setting, inQt(row.of(quality)))));
    }
    return parts.join(QLatin1Char('\n'));
}

} // namespace

QualityBar::QualityBar(QWidget* parent)
    : QWidget(parent), steps_(new QButtonGroup(this)), custom_(new PlainLabel(tr("Custom"))) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(0);
    steps_->setExclusive(false);
    // The one that holds is to be told from the one that has the focus.
    setStyleSheet(QStringLiteral(
        "QPushButton { border: 1px solid palette(mid); padding: 4px 6px; background: palette(button); }"
        "QPushButton:hover, QPushButton:focus { border-color: palette(highlight); }"
        "QPushButton:disabled { color: palette(mid); }"
        "QPushButton:checked { background: palette(highlight); color: palette(highlighted-text); }"));
    for (std::size_t i = 0; i < rtcore::kQualityNames.size(); ++i) {
        auto* button = new QPushButton(settingLabel(rtcore::kQualityNames.at(i)));
        button->setObjectName(inQt(rtcore::kQualityNames.at(i)));
        button->setCheckable(true);
        button->setAccessibleName(tr("Quality: %1").arg(button->text()));
        button->setToolTip(plainTip(tipOf(static_cast<Quality>(i))));
        steps_->addButton(button, static_cast<int>(i));
        row->addWidget(button, 1);
    }
    custom_->setToolTip(plainTip(tr("The settings below are as in none of the three")));
    custom_->setContentsMargins(6, 0, 0, 0);
    row->addWidget(custom_);
    connect(steps_, &QButtonGroup::idClicked, this, [this](int id) {
        steps_->button(id)->setChecked(id == now_); // the server says when it is so
        emit chosen(steps_->button(id)->objectName());
    });
    show(QMap<QString, QString>());
}

QAbstractButton* QualityBar::step(const QString& name) const {
    return findChild<QAbstractButton*>(name, Qt::FindDirectChildrenOnly);
}

bool QualityBar::saysCustom() const { return !custom_->isHidden(); }

void QualityBar::show(const QMap<QString, QString>& values) {
    now_ = values.isEmpty() ? -1 : qualityOf(values);
    for (QAbstractButton* button : steps_->buttons()) {
        button->setChecked(steps_->id(button) == now_);
        button->setEnabled(!values.isEmpty());
    }
    custom_->setVisible(!values.isEmpty() && now_ < 0);
}

} // namespace gui
