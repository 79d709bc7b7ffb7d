#include "gui/dialogs/build_dialog.h"

#include "gui/dialogs/fields.h"
#include "gui/dialogs/file_field.h"
#include "gui/models/option_names.h"
#include "gui/processes/programs.h"

#include "bspbuilder/builder_spec.h"

#include <QCheckBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QSpinBox>

namespace gui {

namespace {

const QStringList kOwn{QStringLiteral("fast"),        QStringLiteral("quality"), QStringLiteral("histogram"),
                       QStringLiteral("progress"),    QStringLiteral("parent"),  QStringLiteral("verbose"),
                       QStringLiteral("very-verbose")};

} // namespace

BuildDialog::BuildDialog(const QString& model, QWidget* parent)
    : JobDialog(bspbuilder::builderSpec(), kOwn, parent),
      input_(new FileField(FileField::Kind::Open, tr("Model"), sceneFilter())),
      output_(new FileField(FileField::Kind::Save, tr("Output file"), tr("kd-trees (*.bsp);;All files (*)"))),
      fast_(new QCheckBox(tr("&Fast build"))),
      report_(new QCheckBox(tr("&Report on model, tree and times"))) {
    setWindowTitle(tr("Build kd-tree"));
    constexpr int kBest = 10, kUsual = 5, kMaxBands = 1000;
    quality_ = numberField(1, kBest, kUsual, tr("Quality of the fast build"));
    histogram_ = numberField(0, kMaxBands, 0, tr("Histogram"));
    histogram_->setSpecialValueText(tr("none"));
    histogram_->setSuffix(tr(" bands"));
    fast_->setToolTip(optionTip(spec(), "fast"));
    quality_->setToolTip(optionTip(spec(), "quality"));
    histogram_->setToolTip(optionTip(spec(), "histogram"));
    report_->setToolTip(optionTip(spec(), "very-verbose"));
    report_->setChecked(true);
    form().addRow(tr("Mode&l:"), input_);
    form().addRow(tr("&Output:"), output_);
    form().addRow(QString(), fast_);
    form().addRow(tr("&Quality:"), quality_);
    form().addRow(tr("&Histogram:"), histogram_);
    form().addRow(QString(), report_);
    connect(input_, &FileField::pathChanged, this, &BuildDialog::proposeOutput);
    connect(output_, &FileField::pathChanged, this, &BuildDialog::check);
    for (QCheckBox* box : {fast_, report_}) connect(box, &QCheckBox::toggled, this, &BuildDialog::check);
    for (QSpinBox* box : {quality_, histogram_})
        connect(box, &QSpinBox::valueChanged, this, &BuildDialog::check);
    connect(fast_, &QCheckBox::toggled, quality_, &QWidget::setEnabled);
    quality_->setEnabled(false);
    input_->setPath(model);
    addCommonParts(tr("Build"));
}

// As long as the user has not named another one.
void BuildDialog::proposeOutput() {
    if (output_->path().isEmpty() || output_->path() == proposed_) {
        const QFileInfo model(input_->path());
        proposed_ = input_->path().isEmpty() ? QString()
                                             : model.absolutePath() + QLatin1Char('/') +
                                                   model.completeBaseName() + QStringLiteral(".bsp");
        output_->setPath(proposed_);
    }
    check();
}

QStringList BuildDialog::ownArguments() const {
    QStringList words{input_->path(), output_->path()};
    if (fast_->isChecked())
        words << QStringLiteral("--fast") << QStringLiteral("--quality=%1").arg(quality_->value());
    if (histogram_->value() > 0) words << QStringLiteral("--histogram=%1").arg(histogram_->value());
    if (report_->isChecked()) words << QStringLiteral("--very-verbose");
    return words;
}

QString BuildDialog::missing() const {
    if (!QFileInfo(input_->path()).isFile()) return tr("Choose a model.");
    if (output_->path().isEmpty()) return tr("Name the file to write.");
    if (output_->path() == input_->path()) return tr("The output would overwrite the model.");
    return {};
}

void BuildDialog::finish() {
    emit wanted({QFileInfo(output_->path()).fileName(), QStringLiteral("BSPBuilder"), arguments(),
                 output_->path(), nullptr});
}

} // namespace gui
