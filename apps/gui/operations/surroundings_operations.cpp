#include "gui/operations/surroundings_operations.h"

#include "gui/operations/actions.h"
#include "gui/operations/scene_editor.h"
#include "gui/session/session.h"
#include "gui/view/frame_view.h"
#include "gui/view/notice_bar.h"

#include "rtcore/look/lighting_preset_name.h"

#include <QFileDialog>
#include <QFileInfo>

namespace gui {

namespace {

std::string nameOf(rtcore::LightingPreset look) {
    return std::string(rtcore::kLightingPresetNames[static_cast<std::size_t>(look)]);
}

} // namespace

SurroundingsOperations::SurroundingsOperations(const GuiContext& context, QObject* parent)
    : QObject(parent), context_(context) {
    Actions& actions = context_.actions;
    actions.on(ActionId::LookSky,
               [this] { edit(command::look(nameOf(rtcore::LightingPreset::Sky)), tr("Lit by a sky")); });
    actions.on(ActionId::LookStudio, [this] {
        edit(command::look(nameOf(rtcore::LightingPreset::Studio)), tr("Lit as in a studio"));
    });
    actions.on(ActionId::LookHeadlight, [this] {
        edit(command::look(nameOf(rtcore::LightingPreset::Headlight)), tr("Lit by a light beside you"));
    });
    actions.on(ActionId::OpenEnvironment, [this] { askForFile(); });
    actions.on(ActionId::NoEnvironment,
               [this] { edit(command::environmentNone(), tr("Neither sky nor environment map")); });
    connect(&actions, &Actions::skyChosen, this, &SurroundingsOperations::open);
}

void SurroundingsOperations::open(const QString& path) {
    if (!context_.session.live()) {
        context_.notice.explain(tr("An environment map lights a scene. Open that first."), {});
        return;
    }
    edit(command::environmentOpen(QFileInfo(path).absoluteFilePath().toStdString()),
         tr("Lit by %1").arg(QFileInfo(path).completeBaseName()));
}

void SurroundingsOperations::askForFile() {
    auto* dialog = new QFileDialog(&context_.window, tr("Open an environment map"), folder_,
                                   tr("Environment maps (*.hdr *.exr *.pfm *.png *.jpg);;All files (*)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) {
        folder_ = QFileInfo(path).absolutePath();
        open(path);
    });
    dialog->open();
}

void SurroundingsOperations::edit(const std::string& line, const QString& done) {
    context_.view.showLive();
    context_.editor.edit(line, [this, done](const Answer& answer) {
        answer.done ? context_.view.tell(done) : context_.notice.explain(answer.text, {});
    });
}

} // namespace gui
