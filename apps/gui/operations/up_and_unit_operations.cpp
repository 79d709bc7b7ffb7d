#include "gui/operations/up_and_unit_operations.h"

#include "gui/dialogs/up_and_unit_dialog.h"
#include "gui/operations/actions.h"
#include "gui/operations/scene_editor.h"
#include "gui/view/frame_view.h"

#include "common/commands/command_lines.h"

namespace gui {

UpAndUnitOperations::UpAndUnitOperations(const GuiContext& context, QObject* parent)
    : QObject(parent), context_(context) {
    context_.actions.on(ActionId::UpAndUnit, [this] { ask(); });
}

void UpAndUnitOperations::ask() {
    SceneEditor& editor = context_.editor;
    auto* dialog = new UpAndUnitDialog(editor.state().up, editor.state().metresPerUnit, &context_.window);
    const auto edit = [this](const std::string& line) {
        context_.view.showLive();
        context_.editor.edit(line, [this](const Answer& answer) {
            if (!answer.done) context_.view.tell(answer.text);
        });
    };
    connect(dialog, &UpAndUnitDialog::upWanted, this,
            [edit](const QString& axis) { edit(app::command::up(axis.toStdString())); });
    connect(dialog, &UpAndUnitDialog::unitWanted, this,
            [edit](float metres) { edit(app::command::units(metres)); });
    connect(dialog, &UpAndUnitDialog::guessWanted, this, [edit] {
        edit(app::command::up("auto"));
        edit(app::command::unitsAsGuessed());
    });
    connect(&editor, &SceneEditor::stateChanged, dialog,
            [dialog, &editor] { dialog->follow(editor.state().up, editor.state().metresPerUnit); });
    dialog->show();
}

} // namespace gui
