#include "gui/operations/section_operations.h"

#include "gui/operations/actions.h"
#include "gui/operations/panel_operations.h"
#include "gui/operations/scene_editor.h"
#include "gui/panels/sections_panel.h"
#include "gui/view/frame_view.h"

namespace gui {

SectionOperations::SectionOperations(const GuiContext& context, QObject* parent)
    : QObject(parent), context_(context), panel_(new SectionsPanel) {
    addPanel(context_, panel_, tr("Sections"), QStringLiteral("sections"), ActionId::SectionsPanel);
    SceneEditor& editor = context_.editor;
    connect(&editor, &SceneEditor::stateChanged, panel_, [this] { panel_->show(context_.editor.state()); });
    const auto enable = [this] { panel_->setEnabled(context_.session.live()); };
    connect(&context_.session, &Session::stateChanged, panel_, enable);
    enable();
    connect(panel_, &SectionsPanel::wanted, this, [this](const std::string& line) {
        context_.view.showLive();
        context_.editor.edit(line);
    });
    connect(panel_, &SectionsPanel::edited, this,
            [this](const QString& step, const std::string& line, std::optional<bool> goesOn) {
                context_.view.showLive();
                context_.editor.follow(step, line, goesOn);
            });
}

} // namespace gui
