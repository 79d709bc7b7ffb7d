#include "gui/dialogs/export_camera_dialog.h"

#include "gui/dialogs/fields.h"
#include "gui/dialogs/file_field.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QPushButton>
#include <QSpinBox>

namespace gui {

ExportCameraDialog::ExportCameraDialog(const QString& path, const QSize& size, Preferences& preferences,
                                       QWidget* parent)
    : QDialog(parent), preferences_(preferences),
      path_(new FileField(FileField::Kind::Save, tr("Path"), tr("Cameras (*.cam);;All files (*)"))) {
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Export camera"));
    path_->setPath(path);
    const QSize kept = preferences.get(pref::exportSize);
    const QSize proposed = kept.isEmpty() ? size : kept;
    width_ = numberField(1, maxOf("width"), proposed.width(), tr("Width"));
    height_ = numberField(1, maxOf("height"), proposed.height(), tr("Height"));
    antialiasing_ =
        numberField(1, maxOf("antialiasing"), preferences.get(pref::exportAntialiasing), tr("Anti-aliasing"));
    antialiasing_->setToolTip(tr("N × N samples per pixel"));
    bloom_ = numberField(0, maxOf("bloom.radius"), preferences.get(pref::exportBloom), tr("Bloom"));
    bloom_->setSpecialValueText(tr("none"));
    bloom_->setSuffix(tr(" pixels"));
    auto* now = new QPushButton(tr("As &now"));
    now->setToolTip(tr("The size that the server draws now"));
    now->setAutoDefault(false);
    connect(now, &QPushButton::clicked, this, [this, size] {
        width_->setValue(size.width());
        height_->setValue(size.height());
    });
    QWidget* sizes = rowOfFields({width_, sign(QStringLiteral("×")), height_, now});
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    auto* ok = buttons->addButton(tr("Export"), QDialogButtonBox::AcceptRole);
    auto* form = new QFormLayout(this);
    form->addRow(tr("&Path:"), path_);
    form->addRow(tr("&Resolution:"), sizes);
    form->addRow(tr("&Anti-aliasing:"), antialiasing_);
    form->addRow(tr("&Bloom:"), bloom_);
    form->addRow(buttons);
    ok->setDefault(true); // once it is in the dialog
    connect(path_, &FileField::pathChanged, this, [this, ok] { ok->setEnabled(!path_->path().isEmpty()); });
    connect(buttons, &QDialogButtonBox::accepted, this, &ExportCameraDialog::finish);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

void ExportCameraDialog::finish() {
    const CameraExport camera{path_->path(), QSize(width_->value(), height_->value()), antialiasing_->value(),
                              bloom_->value()};
    preferences_.set(pref::exportSize, camera.size);
    preferences_.set(pref::exportAntialiasing, camera.antialiasing);
    preferences_.set(pref::exportBloom, camera.bloom);
    emit wanted(camera);
    accept();
}

} // namespace gui
