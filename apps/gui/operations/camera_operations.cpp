#include "gui/operations/camera_operations.h"

#include "gui/dialogs/export_camera_dialog.h"
#include "gui/dialogs/recording_dialog.h"
#include "gui/models/output_file.h"
#include "gui/operations/actions.h"
#include "gui/operations/scene_editor.h"
#include "gui/session/server_sentence.h"
#include "gui/session/session.h"
#include "gui/view/frame_view.h"
#include "gui/view/input_capture.h"
#include "gui/view/notice_bar.h"

#include <QClipboard>
#include <QFileDialog>
#include <QFileInfo>
#include <QGuiApplication>

namespace gui {

CameraOperations::CameraOperations(const GuiContext& context, QObject* parent)
    : QObject(parent), context_(context) {
    Actions& actions = context_.actions;
    actions.on(ActionId::ExportCamera, [this] { exportByDialog(); });
    actions.on(ActionId::ImportCamera, [this] { importCamera(); });
    actions.on(ActionId::Recording, [this] { record(); });
    actions.on(ActionId::Screenshot, [this] { takeScreenshot(); });
    actions.on(ActionId::CopyImage, [this] { copyImage(); });
    actions.on(ActionId::CopyCamera, [this] { copy(); });
    actions.on(ActionId::PasteCamera, [this] { paste(); });
    connect(&context_.view.input(), &InputCapture::commandKey, this, [this](int code, bool) {
        if (context_.session.live() && (code == 'E' || code == 'H')) exportAtOnce(code == 'H');
    });
}

QString CameraOperations::cameraFolder() const {
    const QString folder = context_.preferences.get(pref::cameraFolder);
    return !folder.isEmpty() && QFileInfo(folder).isDir() ? folder : context_.preferences.picturesFolder();
}

void CameraOperations::exportByDialog() {
    const QString path = nextFreeName(cameraFolder(), QStringLiteral("camera"), QStringLiteral("cam"));
    auto* dialog = new ExportCameraDialog(path, context_.session.status().resolution, context_.preferences,
                                          &context_.window);
    connect(dialog, &ExportCameraDialog::wanted, this, [this](const CameraExport& camera) {
        context_.preferences.set(pref::cameraFolder, QFileInfo(camera.path).absolutePath());
        exportCamera(camera);
    });
    dialog->open();
}

void CameraOperations::exportAtOnce(bool highQuality) {
    const Preferences& preferences = context_.preferences;
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
    context_.session.send(line, this, [this, path = camera.path](const Answer& answer) {
        answer.done ? context_.view.tell(tr("The camera was written to %1.").arg(path))
                    : context_.notice.explain(answer.text, {});
    });
}

void CameraOperations::importCamera() {
    auto* dialog = new QFileDialog(&context_.window, tr("Import a camera"), cameraFolder(),
                                   tr("Cameras (*.cam);;All files (*)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) {
        context_.preferences.set(pref::cameraFolder, QFileInfo(path).absolutePath());
        context_.editor.edit(command::loadCamera(path.toStdString()), [this](const Answer& answer) {
            const QString trouble = answer.done ? serverText(answer.text, answer.detail) : answer.text;
            if (!trouble.isEmpty()) context_.notice.explain(trouble, {});
        });
    });
    dialog->open();
}

void CameraOperations::record() {
    if (recording_ == nullptr) {
        recording_ =
            new RecordingDialog(context_.session, context_.preferences.picturesFolder(), &context_.window);
        connect(recording_, &RecordingDialog::filmWanted, this, &CameraOperations::filmWanted);
        // Its list, and the place that it proposes, are of the scene that was shown.
        connect(&context_.editor, &SceneEditor::sceneChanged, recording_,
                [this, scene = context_.editor.scene()] {
                    if (context_.editor.scene() != scene) recording_->close();
                });
    }
    recording_->show();
    recording_->raise();
    recording_->activateWindow();
}

void CameraOperations::takeScreenshot() {
    const QString path = nextFreeName(context_.preferences.picturesFolder(), QStringLiteral("screenshot"),
                                      QStringLiteral("png"));
    const auto tell = [this](bool done, const QString& what, const QString& trouble) {
        done ? context_.view.tell(what) : context_.notice.explain(trouble, {});
    };
    // A better image than the server's is ours to write.
    if (!context_.view.showsLive()) {
        const PictureOrigin origin = context_.view.origin();
        QImage picture = context_.view.picture();
        describe(picture, origin);
        const QString trouble = writeOutput(path, picture);
        return tell(trouble.isEmpty(), tr("The image was written to %1 (%2).").arg(path, originText(origin)),
                    trouble);
    }
    const QString written = tr("The live frame was written to %1.").arg(path);
    context_.session.send(command::screenshot(path.toStdString()), this,
                          [tell, written](const Answer& answer) { tell(answer.done, written, answer.text); });
}

void CameraOperations::copyImage() {
    const FrameView& view = context_.view;
    if (view.shown().isNull()) return;
    QGuiApplication::clipboard()->setImage(view.shown().copy()); // not in the server's memory
    context_.view.tell(view.showsLive() ? tr("The live frame was copied.")
                                        : tr("The image was copied (%1).").arg(originText(view.origin())));
}

void CameraOperations::copy() {
    context_.session.send(command::cameraGet(), this, [this](const Answer& answer) {
        if (answer.done) QGuiApplication::clipboard()->setText(answer.text);
        context_.view.tell(answer.done ? tr("The camera was copied.") : answer.text);
    });
}

void CameraOperations::paste() {
    const std::string text = QGuiApplication::clipboard()->text().toStdString();
    context_.editor.edit(command::cameraPaste(text), [this](const Answer& answer) {
        context_.view.tell(answer.done ? tr("The camera was pasted.") : tr("The clipboard holds no camera."));
        if (answer.done && !answer.text.isEmpty())
            context_.notice.explain(serverText(answer.text, answer.detail), {});
    });
}

} // namespace gui
