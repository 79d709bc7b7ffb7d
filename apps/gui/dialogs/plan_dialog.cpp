#include "gui/dialogs/plan_dialog.h"

#include "gui/dialogs/file_field.h"

#include "rtcore/io/drawings/drawing_format.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QPushButton>

namespace gui {

namespace {

/// Numbers without zeros behind them: 100, and 0.5 where something is drawn larger than it is.
class ScaleBox : public QDoubleSpinBox {
  protected:
    QString textFromValue(double value) const override {
        constexpr int kDigits = 8;
        return locale().toString(value, 'g', kDigits);
    }
};

QDoubleSpinBox* prepared(QDoubleSpinBox* field, double minimum, double maximum, double value,
                         const QString& name) {
    field->setRange(minimum, maximum);
    field->setValue(value);
    field->setAccessibleName(name);
    return field;
}

void select(QComboBox& box, const QString& data) {
    const int index = box.findData(data);
    if (index >= 0) box.setCurrentIndex(index);
}

} // namespace

PlanDialog::PlanDialog(const QString& path, Preferences& preferences, QWidget* parent)
    : QDialog(parent), preferences_(preferences),
      path_(new FileField(FileField::Kind::Save, tr("Plan"),
                          tr("Drawings (*.pdf *.svg *.dxf *.png *.tif);;All files (*)"))),
      side_(new QComboBox), storey_(new QComboBox), paper_(new QComboBox), image_(new QComboBox),
      height_(
          prepared(new QDoubleSpinBox, 0, 10000, preferences.get(pref::planHeight), tr("Height of the cut"))),
      scale_(prepared(new ScaleBox, 0.01, 1e6, preferences.get(pref::planScale), tr("Scale"))),
      dpi_(prepared(new ScaleBox, 10, 2400, preferences.get(pref::planDpi), tr("Resolution"))) {
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Plan"));
    path_->setPath(path);
    side_->addItem(tr("From above: plan of a storey"), QStringLiteral("above"));
    side_->addItem(tr("From the front: elevation"), QStringLiteral("front"));
    side_->addItem(tr("From the back: elevation"), QStringLiteral("back"));
    side_->addItem(tr("From the left: elevation"), QStringLiteral("left"));
    side_->addItem(tr("From the right: elevation"), QStringLiteral("right"));
    side_->addItem(tr("Section of the scene"), QStringLiteral("section"));
    storey_->addItem(tr("Of a camera indoors, else the lowest"), 0);
    paper_->addItem(tr("One sheet, as large as needed"), QStringLiteral("sheet"));
    for (const char* size : {"A4", "A3", "A2", "A1", "A0"})
        paper_->addItem(QLatin1String(size), QLatin1String(size));
    select(*paper_, preferences.get(pref::planPaper));
    image_->addItem(tr("Lines"), QStringLiteral("lines"));
    image_->addItem(tr("Rendered light"), QStringLiteral("light"));
    image_->addItem(tr("Lines over light"), QStringLiteral("both"));
    select(*image_, preferences.get(pref::planImage));
    height_->setSuffix(tr(" m above the floor"));
    height_->setSingleStep(0.1);
    scale_->setPrefix(QStringLiteral("1:"));
    dpi_->setSuffix(tr(" dpi"));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    auto* ok = buttons->addButton(tr("Draw"), QDialogButtonBox::AcceptRole);
    auto* form = new QFormLayout(this);
    form->addRow(tr("&Path:"), path_);
    form->addRow(tr("&View:"), side_);
    form->addRow(tr("&Storey:"), storey_);
    form->addRow(tr("&Cut:"), height_);
    form->addRow(tr("Sca&le:"), scale_);
    form->addRow(tr("P&aper:"), paper_);
    form->addRow(tr("&Image:"), image_);
    form->addRow(tr("&Resolution:"), dpi_);
    form->addRow(buttons);
    ok->setDefault(true); // once it is in the dialog
    connect(side_, &QComboBox::currentIndexChanged, this, &PlanDialog::enableFields);
    connect(path_, &FileField::pathChanged, this, [this, ok] {
        ok->setEnabled(!path_->path().isEmpty());
        enableFields();
    });
    enableFields();
    connect(buttons, &QDialogButtonBox::accepted, this, &PlanDialog::finish);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

void PlanDialog::setStoreys(const std::vector<double>& floors) {
    for (std::size_t i = 0; i < floors.size(); ++i) {
        const int number = static_cast<int>(i) + 1;
        storey_->addItem(tr("%1: floor at %2 m").arg(number).arg(locale().toString(floors[i], 'f', 2)),
                         number);
    }
}

bool PlanDialog::isImage() const {
    return rtcore::drawingFormatOf(path_->path().toStdString()) == rtcore::DrawingFormat::Image;
}

void PlanDialog::enableFields() {
    const bool above = side_->currentIndex() == 0;
    storey_->setEnabled(above);
    height_->setEnabled(above);
    image_->setEnabled(isImage());
    dpi_->setEnabled(isImage());
}

void PlanDialog::finish() {
    const PlanWish plan{path_->path(),
                        side_->currentData().toString(),
                        scale_->value(),
                        paper_->currentData().toString(),
                        storey_->currentData().toInt(),
                        height_->value(),
                        dpi_->value(),
                        isImage() ? image_->currentData().toString() : QStringLiteral("lines")};
    preferences_.set(pref::planScale, plan.scale);
    preferences_.set(pref::planPaper, plan.paper);
    preferences_.set(pref::planHeight, plan.height);
    preferences_.set(pref::planDpi, plan.dpi);
    if (isImage()) preferences_.set(pref::planImage, plan.image);
    emit wanted(plan);
    accept();
}

} // namespace gui
