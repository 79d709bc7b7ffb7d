#include "gui/panels/lights_panel.h"

#include <QButtonGroup>
#include <QCheckBox>
#include <QGroupBox>
#include <QLabel>
#include <QRadioButton>
#include <QScrollArea>
#include <QVBoxLayout>

namespace gui {

namespace {

QGroupBox* addBox(const QString& title, QVBoxLayout& column) {
    auto* box = new QGroupBox(title);
    new QVBoxLayout(box);
    column.addWidget(box);
    return box;
}

// '&' is a letter here.
QString plain(QString name) { return name.replace(QLatin1Char('&'), QLatin1String("&&")); }

} // namespace

LightsPanel::LightsPanel(QWidget* parent)
    : QWidget(parent), lights_(new QButtonGroup(this)), environments_(new QButtonGroup(this)),
      nothing_(new QLabel(tr("The scene has neither lights nor environment maps."))) {
    auto* column = new QWidget;
    auto* groups = new QVBoxLayout(column);
    lightBox_ = addBox(tr("Lights"), *groups);
    environmentBox_ = addBox(tr("Environment"), *groups);
    nothing_->setWordWrap(true);
    groups->addWidget(nothing_);
    groups->addStretch(1);
    auto* area = new QScrollArea;
    area->setWidget(column);
    area->setWidgetResizable(true);
    area->setFrameShape(QFrame::NoFrame);
    area->setFocusPolicy(Qt::NoFocus);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(area);
    lights_->setExclusive(false);
    // clicked: by the user, not by us
    connect(lights_, &QButtonGroup::idClicked, this,
            [this](int number) { emit lightSwitched(number, lights_->button(number)->isChecked()); });
    connect(environments_, &QButtonGroup::idClicked, this, &LightsPanel::environmentChosen);
    show({}, {});
}

QAbstractButton* LightsPanel::light(int number) const { return lights_->button(number); }
QAbstractButton* LightsPanel::environment(int number) const { return environments_->button(number); }

void LightsPanel::refill(QButtonGroup& buttons, const QList<NamedSwitch>& switches, bool lights) {
    const QList<QAbstractButton*> old = buttons.buttons();
    if (old.size() != switches.size()) {
        for (QAbstractButton* button : old) {
            buttons.removeButton(button);
            delete button;
        }
        for (int i = 0; i < switches.size(); ++i) {
            QAbstractButton* button = nullptr;
            if (lights)
                button = new QCheckBox;
            else
                button = new QRadioButton;
            (lights ? lightBox_ : environmentBox_)->layout()->addWidget(button);
            buttons.addButton(button, i);
        }
    }
    for (int i = 0; i < switches.size(); ++i) {
        const QString& name = switches[i].name;
        const QString number = QString::number(i + 1); // as on the keys
        QAbstractButton* button = buttons.button(i);
        const QString shown = !name.isEmpty() ? name
                              : lights        ? tr("Light %1").arg(number)
                                              : tr("Map %1").arg(number);
        button->setText(plain(shown));
        button->setAccessibleName(shown);
        button->setToolTip(i >= 9   ? QString()
                           : lights ? tr("Key: %1").arg(number)
                                    : tr("Keys: M and %1").arg(number));
        button->setChecked(switches[i].on);
    }
}

void LightsPanel::show(const QList<NamedSwitch>& lights, const QList<NamedSwitch>& environments) {
    refill(*lights_, lights, true);
    refill(*environments_, environments, false);
    lightBox_->setVisible(!lights.isEmpty());
    environmentBox_->setVisible(!environments.isEmpty());
    nothing_->setVisible(lights.isEmpty() && environments.isEmpty());
}

} // namespace gui
