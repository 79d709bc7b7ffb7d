#include "gui/dialogs/field_of_view_dialog.h"

#include "rtcore/scene/focal_length.h"

#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLocale>
#include <QSignalBlocker>

namespace gui {

namespace {

constexpr double kNarrowestAngle = 0.5, kWidestAngle = 170; ///< degrees

QDoubleSpinBox* field(double minimum, double maximum, const QString& unit, const QString& name) {
    auto* box = new QDoubleSpinBox;
    box->setDecimals(1);
    box->setRange(minimum, maximum);
    box->setSuffix(unit);
    box->setAccessibleName(name);
    box->setKeyboardTracking(false); // a number counts when it is typed, not each digit
    return box;
}

void set(QDoubleSpinBox& box, double value) {
    const QSignalBlocker quiet(box);
    box.setValue(value);
}

} // namespace

QString fieldOfViewText(double degrees) {
    return FieldOfViewDialog::tr("%1° (%2 mm)")
        .arg(QLocale().toString(degrees, 'f', 1),
             QLocale().toString(rtcore::focalLengthOfAngle(degrees), 'f', 0));
}

FieldOfViewDialog::FieldOfViewDialog(double degrees, QWidget* parent)
    : QDialog(parent), angle_(field(kNarrowestAngle, kWidestAngle, tr("°"), tr("Angle"))),
      lens_(field(rtcore::focalLengthOfAngle(kWidestAngle), rtcore::focalLengthOfAngle(kNarrowestAngle),
                  tr(" mm"), tr("Focal length"))) {
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Field of view"));
    angle_->setToolTip(tr("From the left to the right edge of the image. Eyes that look ahead: about 60°"));
    lens_->setToolTip(
        tr("Of a camera for film of 36 × 24 mm: 18 mm is wide, 50 mm usual, 85 mm for portraits"));
    auto* form = new QFormLayout(this);
    form->addRow(tr("&Angle:"), angle_);
    form->addRow(tr("&Focal length:"), lens_);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    form->addRow(buttons);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
    connect(angle_, &QDoubleSpinBox::valueChanged, this, [this](double angle) {
        set(*lens_, rtcore::focalLengthOfAngle(angle));
        emit wanted(angle);
    });
    connect(lens_, &QDoubleSpinBox::valueChanged, this, [this](double millimetres) {
        const double angle = rtcore::angleOfFocalLength(millimetres);
        set(*angle_, angle);
        emit wanted(angle);
    });
    follow(degrees);
}

void FieldOfViewDialog::follow(double degrees) {
    if (degrees <= 0) return;
    set(*angle_, degrees);
    set(*lens_, rtcore::focalLengthOfAngle(degrees));
}

} // namespace gui
