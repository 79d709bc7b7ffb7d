#include "gui/operations/light_operations.h"

#include "gui/models/preferences.h"
#include "gui/operations/actions.h"
#include "gui/operations/panel_operations.h"
#include "gui/operations/scene_editor.h"
#include "gui/panels/light_fields.h"
#include "gui/panels/lights_panel.h"
#include "gui/panels/sky_fields.h"
#include "gui/view/frame_view.h"
#include "gui/view/light_handles.h"
#include "gui/view/notice_bar.h"

#include <QAction>

#include <utility>

namespace gui {

namespace {

QVector3D vectorOf(const rtcore::Vec3& v) { return {v.x, v.y, v.z}; }

QList<LightMark> marksOf(const QList<ShownLight>& lights) {
    QList<LightMark> marks;
    for (const ShownLight& light : lights) {
        if (!light.description) continue;
        const rtcore::Light& shines = light.description->light;
        const rtcore::LightTraits& traits = traitsOf(shines);
        LightMark mark{.id = light.id,
                       .on = light.on,
                       .name = lightText(light),
                       .colour = lightColour(*light.description),
                       .position = traits.position ? vectorOf(shines.position) : -vectorOf(shines.direction),
                       .far = !traits.position};
        if (traits.position && traits.direction) mark.direction = vectorOf(shines.direction);
        marks.append(mark);
    }
    return marks;
}

} // namespace

LightOperations::LightOperations(const GuiContext& context, QObject* parent)
    : QObject(parent), context_(context), panel_(new LightsPanel(context.actions[ActionId::LightMarks],
                                                                 context.actions[ActionId::OpenEnvironment])),
      handles_(new LightHandles(context.view, context.session, this)) {
    addPanel(context_, panel_, tr("Lights"), QStringLiteral("lights"), ActionId::LightsPanel);
    context_.actions.bind(ActionId::LightMarks, pref::lightMarks);
    const auto showMarks = [this] { handles_->setShown(context_.preferences.get(pref::lightMarks)); };
    connect(&context_.preferences, &Preferences::changed, handles_, showMarks);
    showMarks();
    connect(&context_.editor, &SceneEditor::stateChanged, this, &LightOperations::showState);
    const auto enable = [this] { panel_->setEnabled(context_.session.live()); };
    connect(&context_.session, &Session::stateChanged, panel_, enable);
    enable();
    connectPanel();
    connectHandles();
}

void LightOperations::connectPanel() {
    SceneEditor& editor = context_.editor;
    connect(panel_, &LightsPanel::lightSwitched, &editor, &SceneEditor::switchLight);
    connect(panel_, &LightsPanel::environmentChosen, &editor, &SceneEditor::chooseEnvironment);
    connect(panel_, &LightsPanel::skyWanted, this, &LightOperations::showSky);
    connect(panel_, &LightsPanel::noBackgroundWanted, this,
            [this] { context_.editor.edit(command::environmentNone()); });
    connect(panel_, &LightsPanel::lightSelected, handles_, &LightHandles::setSelected);
    connect(panel_, &LightsPanel::lightEdited, this,
            [this](const QString& step, const std::string& line) { follow(step, line, {}); });
    connect(&panel_->sky(), &SkyFields::edited, this,
            [this](const QString& step, const std::string& line) { follow(step, line, {}); });
    connect(&panel_->sky(), &SkyFields::sunAheadWanted, this, [this] {
        const QVector3D ahead = context_.session.status().view.forward;
        follow(QStringLiteral("sky direction"), command::skyDirection(numbersOf(ahead)), {});
    });
    connect(panel_, &LightsPanel::addWanted, this,
            [this](const std::string& kind) { add(command::lightAdd(kind)); });
    connect(panel_, &LightsPanel::copyWanted, this, [this](int id) { add(command::lightCopy(id)); });
    connect(panel_, &LightsPanel::removeWanted, this,
            [this](int id) { context_.editor.edit(command::lightRemove(id)); });
}

// A scene that shows a map may have a sky beside it.
void LightOperations::showSky() {
    const SceneState& state = context_.editor.state();
    if (state.sky && !state.sky->studio)
        return context_.editor.chooseEnvironment(static_cast<int>(state.environments.size()) - 1);
    follow(QStringLiteral("sky"), command::sky(true), {});
}

void LightOperations::connectHandles() {
    const auto step = [](int id) { return QStringLiteral("light move %1").arg(id); };
    connect(handles_, &LightHandles::picked, this, &LightOperations::select);
    connect(handles_, &LightHandles::moved, this,
            [this, step](int id, const QVector3D& position, bool goesOn) {
                follow(step(id), command::lightMove(id, positionOf(position, context_.session.status().view)),
                       goesOn);
            });
    connect(handles_, &LightHandles::turned, this, &LightOperations::turn);
    connect(handles_, &LightHandles::movedOntoSurface, this,
            [this, step](int id, const QPointF& place, bool goesOn) {
                follow(step(id), command::lightMoveSeen(id, place.x(), place.y()), goesOn);
            });
}

void LightOperations::turn(int id, const QVector3D& towards, bool goesOn) {
    if (id == context_.editor.state().sun)
        return follow(QStringLiteral("sky direction"), command::skyDirection(numbersOf(towards)), goesOn);
    follow(QStringLiteral("light aim %1").arg(id), command::lightAim(id, numbersOf(-towards)), goesOn);
}

void LightOperations::select(int id) {
    panel_->select(id);
    handles_->setSelected(id);
}

// A better image of the light before is not what one looks at while it changes.
void LightOperations::follow(const QString& step, const std::string& line, std::optional<bool> goesOn) {
    context_.view.showLive();
    context_.editor.follow(step, line, goesOn);
}

// The answer is the new light's id.
void LightOperations::add(const std::string& line) {
    context_.view.showLive();
    context_.editor.edit(line, [this](const Answer& answer) {
        if (!answer.done) return context_.notice.explain(answer.text, {});
        added_ = answer.text.toInt();
    });
}

void LightOperations::showState() {
    const SceneState& state = context_.editor.state();
    panel_->show(state);
    handles_->setMarks(marksOf(state.lights), state);
    if (added_ != 0 && lightOf(state, added_) != nullptr) select(std::exchange(added_, 0));
    if (panel_->selected() != 0 && lightOf(state, panel_->selected()) == nullptr) select(0);
}

} // namespace gui
