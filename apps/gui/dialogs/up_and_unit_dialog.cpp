#include "gui/dialogs/up_and_unit_dialog.h"

#include "gui/panels/value_box.h"

#include "rtcore/scene/up_axis.h"
#include "rtcore/settings/settings_table.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QPushButton>
#include <QSignalBlocker>

#include <array>
#include <utility>

namespace gui {

namespace {

constexpr double kShortestUnit = 1e-9, kLongestUnit = 1e9; ///< metres

QString metresText(double metres) {
    return QString::fromStdString(rtcore::settingText(static_cast<float>(metres)));
}

/// Each with its metres, as settingText() writes them.
void addUnits(QComboBox& box) {
    const std::array<std::pair<const char*, QString>, 5> units{{{"mm", UpAndUnitDialog::tr("Millimetres")},
                                                                {"cm", UpAndUnitDialog::tr("Centimetres")},
                                                                {"m", UpAndUnitDialog::tr("Metres")},
                                                                {"in", UpAndUnitDialog::tr("Inches")},
                                                                {"ft", UpAndUnitDialog::tr("Feet")}}};
    for (const auto& [name, text] : units) box.addItem(text, metresText(*rtcore::unitNamed(name)));
    box.addItem(UpAndUnitDialog::tr("Others"), QString());
}

} // namespace

UpAndUnitDialog::UpAndUnitDialog(const QString& up, float metresPerUnit, QWidget* parent)
    : QDialog(parent), up_(new QComboBox), unit_(new QComboBox),
      metres_(new ValueBox(kShortestUnit, kLongestUnit)) {
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Up axis and unit"));
    for (const rtcore::Vec3 axis : rtcore::kAxes) {
        const QString name = QString::fromStdString(std::string(rtcore::axisName(axis)));
        up_->addItem(name.toUpper(), name);
    }
    addUnits(*unit_);
    metres_->setSuffix(tr(" m"));
    metres_->setKeyboardTracking(false);
    up_->setToolTip(tr("This axis of the model points to the sky"));
    unit_->setToolTip(tr("What the model's numbers count; walking and depth of field go by it"));
    metres_->setToolTip(tr("How long a unit of the model is"));
    auto* form = new QFormLayout(this);
    form->addRow(tr("&Up:"), up_);
    form->addRow(tr("U&nit:"), unit_);
    form->addRow(tr("&Length of a unit:"), metres_);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    QPushButton* guess = buttons->addButton(tr("&As guessed"), QDialogButtonBox::ResetRole);
    guess->setToolTip(tr("By the format, the program that wrote it, and the shape of the model"));
    form->addRow(buttons);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
    connect(guess, &QPushButton::clicked, this, &UpAndUnitDialog::guessWanted);
    connect(up_, &QComboBox::currentIndexChanged, this,
            [this] { emit upWanted(up_->currentData().toString()); });
    connect(unit_, &QComboBox::currentIndexChanged, this, [this] {
        const QString metres = unit_->currentData().toString();
        if (metres.isEmpty()) return metres_->setFocus();
        emit unitWanted(metres.toFloat());
    });
    connect(metres_, &ValueBox::valueChanged, this,
            [this](double metres) { emit unitWanted(static_cast<float>(metres)); });
    follow(up, metresPerUnit);
}

void UpAndUnitDialog::follow(const QString& up, float metresPerUnit) {
    const QSignalBlocker quietUp(up_), quietUnit(unit_), quietMetres(metres_);
    up_->setCurrentIndex(up_->findData(up));
    const int known = unit_->findData(metresText(metresPerUnit));
    unit_->setCurrentIndex(known >= 0 ? known : unit_->count() - 1);
    const double metres = metresText(metresPerUnit).toDouble(); // without the digits of a float's rounding
    if (metres_->value() != metres) metres_->setValue(metres);
}

} // namespace gui
