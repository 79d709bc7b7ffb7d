#include "gui/operations/mode_operations.h"

#include "gui/models/preferences.h"
#include "gui/operations/actions.h"
#include "gui/operations/scene_editor.h"
#include "gui/session/session.h"
#include "gui/view/frame_view.h"
#include "gui/view/input_capture.h"

#include "rtcore/scene/up_axis.h"

#include <QAction>

#include <utility>

namespace gui {

ModeOperations::ModeOperations(const GuiContext& context, QObject* parent)
    : QObject(parent), context_(context), cube_(new ViewCube(context.view)) {
    Session& session = context_.session;
    context_.actions.bind(ActionId::ShowCube, pref::showCube);
    context_.actions.onToggle(ActionId::Orbit, [this](bool on) { setOrbits(on); });
    for (const auto& [id, mode] :
         {std::pair{ActionId::Walk, Mode::Walk}, std::pair{ActionId::Fly, Mode::Fly}}) {
        context_.actions.on(id, [this, mode] {
            showMode(); // the click has changed the check mark, and the server may refuse
            choose(mode);
        });
    }
    connect(cube_, &ViewCube::modeChosen, this, &ModeOperations::choose);
    connect(cube_, &ViewCube::sideChosen, this,
            [this](const QString& side) { context_.editor.edit(command::cameraView(side.toStdString())); });
    connect(&context_.preferences, &Preferences::changed, this, &ModeOperations::showCube);
    connect(&session, &Session::stateChanged, this, [this] {
        showCube();
        showMode();
    });
    connect(&session, &Session::frameChanged, this, [this] {
        showCube();
        cube_->setView(context_.session.status().view);
    });
    // Who walks and stands where the camera was changes no image.
    connect(&session, &Session::statusChanged, this, &ModeOperations::showMode);
    connect(&context_.editor, &SceneEditor::sceneChanged, this, [this] {
        const bool orbits = !context_.editor.state().indoors;
        context_.actions[ActionId::Orbit]->setChecked(orbits);
        context_.view.input().setHand(orbits ? Hand::Turns : Hand::Looks);
        showMode();
    });
    connect(&context_.editor, &SceneEditor::stateChanged, this, [this] {
        const auto up = rtcore::axisNamed(context_.editor.state().up.toStdString());
        if (up) cube_->setUp({up->x, up->y, up->z});
    });
    showCube();
}

void ModeOperations::showCube() {
    const bool shows = context_.preferences.get(pref::showCube) && context_.session.live() &&
                       !context_.session.frame().isNull();
    if (shows != cube_->isVisibleTo(&context_.view)) cube_->setVisible(shows);
}

// The view stays, but that a body falls onto the ground. A model that cannot be walked in stays in the hand.
void ModeOperations::choose(Mode mode) {
    if (mode != Mode::Walk) {
        if (context_.session.status().view.walking) context_.session.send(command::fly());
        return setOrbits(mode == Mode::Orbit);
    }
    context_.session.send(command::walk(), this, [this](const Answer& answer) {
        answer.done ? setOrbits(false) : context_.view.tell(answer.text);
    });
}

void ModeOperations::setOrbits(bool orbits) {
    context_.actions[ActionId::Orbit]->setChecked(orbits);
    context_.view.input().setHand(orbits ? Hand::Turns : Hand::Looks);
    const DragTexts drags = dragTexts(context_.view.input().mouseScheme());
    context_.view.tell(orbits ? tr("Turn the model: %1; move it: %2; go nearer: %3")
                                    .arg(drags.turning, drags.moving, drags.nearing)
                              : tr("A click takes the mouse, which looks around; Esc gives it back."));
    showMode();
}

// Who begins to walk, by the key or from another program, wants to look around.
void ModeOperations::showMode() {
    const bool walks = context_.session.status().view.walking;
    if (!std::exchange(walks_, walks) && walks && context_.view.input().hand() == Hand::Turns)
        setOrbits(false);
    const bool orbits = context_.view.input().hand() == Hand::Turns;
    const Mode mode = orbits ? Mode::Orbit : walks ? Mode::Walk : Mode::Fly;
    cube_->setMode(mode);
    const bool live = context_.session.live();
    context_.actions[ActionId::Walk]->setChecked(live && mode == Mode::Walk);
    context_.actions[ActionId::Fly]->setChecked(live && mode == Mode::Fly);
}

} // namespace gui
