#include "gui/operations/camera_operations.h"

#include "gui/dialogs/export_camera_dialog.h"
#include "gui/dialogs/recording_dialog.h"
#include "gui/operations/actions.h"
#include "gui/operations/scene_editor.h"
#include "gui/session/session.h"
#include "gui/view/frame_view.h"
#include "gui/view/input_capture.h"
#include "gui/view/notice_bar.h"

#include <QClipboard>
#include <QFileDialog>
#include <QFileInfo>
#include <QGuiApplication>

namespace gui {

CameraOperations::CameraOperations(const Desk& desk, QObject* parent) : QObject(parent), desk_(desk) {
    Actions& actions = desk_.actions;
    actions.on(ActionId::ExportCamera, [this] { exportByDialog(); });
    actions.on(ActionId::ImportCamera, [this] { importCamera(); });
    actions.on(ActionId::Recording, [this] { record(); });
    actions.on(ActionId::Screenshot, [this] { takeScreenshot(); });
    actions.on(ActionId::CopyCamera, [this] { copy(); });
    actions.on(ActionId::PasteCamera, [this] { paste(); });
    connect(&desk_.view.input(), &InputCapture::commandKey, this, [this](int code, bool) {
        if (desk_.session.live() && (code == 'E' || code == 'H')) exportAtOnce(code == 'H');
    });
}

QString CameraOperations::cameraFolder() const {
    const QString folder = desk_.preferences.get(pref::cameraFolder);
    return !folder.isEmpty() && QFileInfo(folder).isDir() ? folder : desk_.preferences.picturesFolder();
}

void CameraOperations::exportByDialog() {
    const QString path = nextFreeName(cameraFolder(), QStringLiteral("camera"), QStringLiteral("cam"));
    auto* dialog =
        new ExportCameraDialog(path, desk_.session.status().resolution, desk_.preferences, &desk_.window);
    connect(dialog, &ExportCameraDialog::wanted, this, [this](const CameraExport& camera) {
        desk_.preferences.set(pref::cameraFolder, QFileInfo(camera.path).absolutePath());
        exportCamera(camera);
    });
    dialog->open();
}

void CameraOperations::exportAtOnce(bool highQuality) {
    const Preferences& preferences = desk_.preferences;
    CameraExport camera;
    camera.path = nextFreeName(cameraFolder(), QStringLiteral("camera"), QStringLiteral("cam"));
    if (highQuality) {
        camera.size = preferences.get(pref::highQualitySize);
        camera.antialiasing = preferences.get(pref::highQualityAntialiasing);
        camera.bloom = preferences.get(pref::highQualityBloom);
    }
    exportCamera(camera);
}

void CameraOperations::exportCamera(const CameraExport& camera) {
    const std::string path = camera.path.toStdString();
    const std::string line = camera.size.isEmpty()
                                 ? command::exportCamera(path)
                                 : command::exportCamera(path, camera.size.width(), camera.size.height(),
                                                         camera.antialiasing, camera.bloom);
    desk_.session.send(line, this, [this, path = camera.path](const Answer& answer) {
        answer.done ? desk_.view.tell(tr("The camera was written to %1.").arg(path))
                    : desk_.notice.explain(answer.text, {});
    });
}

void CameraOperations::importCamera() {
    auto* dialog = new QFileDialog(&desk_.window, tr("Import a camera"), cameraFolder(),
                                   tr("Cameras (*.cam);;All files (*)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) {
        desk_.preferences.set(pref::cameraFolder, QFileInfo(path).absolutePath());
        desk_.editor.place(command::loadCamera(path.toStdString()),
                           tr("import %1").arg(QFileInfo(path).fileName()), [this](const Answer& answer) {
                               if (!answer.done) desk_.notice.explain(answer.text, {});
                           });
    });
    dialog->open();
}

void CameraOperations::record() {
    if (recording_ == nullptr) {
        recording_ = new RecordingDialog(desk_.session, desk_.preferences.picturesFolder(), &desk_.window);
        connect(recording_, &RecordingDialog::filmWanted, this, &CameraOperations::filmWanted);
    }
    recording_->show();
    recording_->raise();
    recording_->activateWindow();
}

void CameraOperations::takeScreenshot() {
    const QString path =
        nextFreeName(desk_.preferences.picturesFolder(), QStringLiteral("screenshot"), QStringLiteral("png"));
    const auto tell = [this, path](bool done, const QString& trouble) {
        done ? desk_.view.tell(tr("The picture was written to %1.").arg(path))
             : desk_.notice.explain(trouble, {});
    };
    // A better picture than the server's is ours to write.
    if (!desk_.view.showsLive())
        return tell(desk_.view.picture().save(path), tr("%1 cannot be written.").arg(path));
    desk_.session.send(command::screenshot(path.toStdString()), this,
                       [tell](const Answer& answer) { tell(answer.done, answer.text); });
}

void CameraOperations::copy() {
    desk_.session.send(command::cameraGet(), this, [this](const Answer& answer) {
        if (answer.done) QGuiApplication::clipboard()->setText(answer.text);
        desk_.view.tell(answer.done ? tr("The camera was copied.") : answer.text);
    });
}

void CameraOperations::paste() {
    desk_.editor.placeByText(QGuiApplication::clipboard()->text(), tr("paste camera"),
                             [this](const Answer& answer) {
                                 desk_.view.tell(answer.done ? tr("The camera was pasted.")
                                                             : tr("The clipboard holds no camera."));
                             });
}

} // namespace gui
