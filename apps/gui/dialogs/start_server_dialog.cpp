#include "gui/dialogs/start_server_dialog.h"

#include "gui/dialogs/fields.h"
#include "gui/dialogs/file_field.h"
#include "gui/processes/programs.h"
#include "gui/session/server_list.h"
#include "gui/view/plain_widgets.h"

#include "ipc/layout/limits.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QLineEdit>
#include <QProcess>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

namespace gui {

namespace {

enum ServerSize { AsWindow, AsScene, OwnSize };

} // namespace

StartServerDialog::StartServerDialog(Preferences& preferences, const QString& instance, const QSize& window,
                                     QWidget* parent)
    : QDialog(parent), preferences_(preferences), window_(window),
      scene_(new FileField(FileField::Kind::Open, tr("Scene or model"), sceneFilter())),
      camera_(new FileField(FileField::Kind::Open, tr("Camera"), tr("Cameras (*.cam);;All files (*)"))),
      settings_(new FileField(FileField::Kind::Open, tr("Settings"), tr("Settings (*.set);;All files (*)"))),
      instance_(new QLineEdit), further_(new QLineEdit), size_(new QComboBox) {
    constexpr int kMaxPixels = ipc::kMaxFrameSide, kMaxThreads = 1024;
    width_ = numberField(1, kMaxPixels, window.width(), tr("Width"));
    height_ = numberField(1, kMaxPixels, window.height(), tr("Height"));
    threads_ = numberField(0, kMaxThreads, 0, tr("Threads"));
    threads_->setSpecialValueText(tr("all cores"));
    limit_ = new QDoubleSpinBox;
    constexpr double kMaxFrames = 1000;
    limit_->setRange(0, kMaxFrames);
    limit_->setDecimals(0);
    limit_->setSpecialValueText(tr("none"));
    limit_->setSuffix(tr(" frames/s"));
    keep_ = new QCheckBox(tr("&Keep the server running when the window closes"));
    smooth_ = new QCheckBox(tr("Fewer &pixels while something moves, so that it moves smoothly"));
    keep_->setChecked(preferences.get(pref::keepServers));
    trouble_ = wrappedLabel();
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Start new server"));
    build(instance);
    check();
}

void StartServerDialog::build(const QString& name) {
    const QStringList recent = preferences_.recentFiles();
    scene_->setPath(recent.value(0));
    instance_->setText(freeInstanceName(name));
    smooth_->setChecked(preferences_.get(pref::frameTime) > 0);
    further_->setPlaceholderText(QStringLiteral("--setting shadows=off --flip-textures"));
    size_->addItems({tr("as large as the window"), tr("from scene"), tr("custom")});
    QWidget* sizes = rowOfFields({size_, width_, sign(QStringLiteral("×")), height_});
    auto* form = new QFormLayout;
    form->addRow(tr("&Scene or model:"), scene_);
    form->addRow(tr("&Name:"), instance_);
    form->addRow(tr("&Resolution:"), sizes);
    form->addRow(tr("&Camera:"), camera_);
    form->addRow(tr("S&ettings:"), settings_);
    form->addRow(tr("&Threads:"), threads_);
    form->addRow(tr("Frame &limit:"), limit_);
    form->addRow(tr("&More options:"), further_);
    form->addRow(QString(), smooth_);
    form->addRow(QString(), keep_);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    start_ = buttons->addButton(tr("Start"), QDialogButtonBox::AcceptRole);
    auto* column = new QVBoxLayout(this);
    column->addLayout(form);
    column->addWidget(trouble_);
    column->addWidget(buttons);
    start_->setDefault(true); // once it is in the dialog

    connect(buttons, &QDialogButtonBox::accepted, this, &StartServerDialog::finish);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(size_, &QComboBox::currentIndexChanged, this, &StartServerDialog::check);
    connect(instance_, &QLineEdit::textChanged, this, &StartServerDialog::check);
    for (FileField* field : {scene_, camera_, settings_})
        connect(field, &FileField::pathChanged, this, &StartServerDialog::check);
}

void StartServerDialog::check() {
    width_->setEnabled(size_->currentIndex() == OwnSize);
    height_->setEnabled(size_->currentIndex() == OwnSize);
    const auto missing = [](const FileField* field, bool required) {
        return field->path().isEmpty() ? required : !QFileInfo(field->path()).isFile();
    };
    QString trouble;
    if (!isInstanceName(instance_->text())) trouble = tr("A name has 1 to 32 letters, digits, “_” or “-”.");
    if (missing(camera_, false)) trouble = tr("The camera's file is not there.");
    if (missing(settings_, false)) trouble = tr("The file of settings is not there.");
    if (missing(scene_, true)) trouble = tr("Choose a scene or a model.");
    trouble_->setText(trouble);
    start_->setEnabled(trouble.isEmpty());
}

QSize StartServerDialog::resolution() const {
    switch (size_->currentIndex()) {
    case AsScene:
        return {};
    case OwnSize:
        return {width_->value(), height_->value()};
    default:
        return window_ * preferences_.get(pref::pictureScale) / 100;
    }
}

QStringList StartServerDialog::options() const {
    QStringList options;
    if (!camera_->path().isEmpty()) options << QStringLiteral("--camera=") + camera_->path();
    if (!settings_->path().isEmpty()) options << QStringLiteral("--set=") + settings_->path();
    if (threads_->value() > 0) options << QStringLiteral("--threads=%1").arg(threads_->value());
    if (limit_->value() > 0) options << QStringLiteral("--fps-limit=%1").arg(limit_->value());
    if (smooth_->isChecked()) options += frameTimeOption(qMax(1, preferences_.get(pref::frameTime)));
    return options + QProcess::splitCommand(further_->text());
}

ServerRequest StartServerDialog::request() const {
    return {scene_->path(), instance_->text(), resolution(), options()};
}

void StartServerDialog::finish() {
    preferences_.set(pref::keepServers, keep_->isChecked());
    emit wanted(request());
    accept();
}

} // namespace gui
