#include "gui/operations/section_operations.h"

#include "gui/models/preferences.h"
#include "gui/operations/actions.h"
#include "gui/operations/panel_operations.h"
#include "gui/operations/scene_editor.h"
#include "gui/panels/sections_panel.h"
#include "gui/view/frame_view.h"
#include "gui/view/section_handles.h"

#include <QDockWidget>

namespace gui {

SectionOperations::SectionOperations(const GuiContext& context, QObject* parent)
    : QObject(parent), context_(context), panel_(new SectionsPanel),
      handles_(new SectionHandles(context.view, context.session, this)) {
    const QDockWidget* dock =
        addPanel(context_, panel_, tr("Sections"), QStringLiteral("sections"), ActionId::SectionsPanel);
    connect(dock, &QDockWidget::visibilityChanged, this, [this](bool seen) {
        panelSeen_ = seen;
        showHandles();
    });
    context_.actions.bind(ActionId::SectionHandles, pref::sectionHandles);
    connect(&context_.preferences, &Preferences::changed, this, &SectionOperations::showHandles);
    showHandles();
    connect(&context_.editor, &SceneEditor::stateChanged, this, [this] {
        panel_->show(context_.editor.state());
        handles_->setState(context_.editor.state());
        handles_->setSelected(panel_->selectedNumber());
    });
    const auto enable = [this] { panel_->setEnabled(context_.session.live()); };
    connect(&context_.session, &Session::stateChanged, panel_, enable);
    enable();
    connectPanel();
    connectHandles();
}

void SectionOperations::connectPanel() {
    connect(panel_, &SectionsPanel::selectionChanged, handles_, &SectionHandles::setSelected);
    connect(panel_, &SectionsPanel::wanted, this, [this](const std::string& line) {
        context_.view.showLive();
        context_.editor.edit(line);
    });
    connect(panel_, &SectionsPanel::edited, this, &SectionOperations::follow);
}

void SectionOperations::connectHandles() {
    connect(handles_, &SectionHandles::picked, panel_, &SectionsPanel::select);
    connect(handles_, &SectionHandles::moved, this,
            [this](int number, const rtcore::FilePoint& point, bool goesOn) {
                follow(SectionsPanel::stepAt(number), command::sectionAt(number, point), goesOn);
            });
    connect(handles_, &SectionHandles::turned, this,
            [this](int number, const rtcore::FilePoint& point, const rtcore::Vec3d& normal, bool goesOn) {
                follow(QStringLiteral("section plane %1").arg(number),
                       command::sectionPlane(number, point, {normal.x, normal.y, normal.z}), goesOn);
            });
}

void SectionOperations::showHandles() {
    handles_->setShown(panelSeen_ || context_.preferences.get(pref::sectionHandles));
}

// A better image of the section before is not what one looks at while it changes.
void SectionOperations::follow(const QString& step, const std::string& line, std::optional<bool> goesOn) {
    context_.view.showLive();
    context_.editor.follow(step, line, goesOn);
}

} // namespace gui
