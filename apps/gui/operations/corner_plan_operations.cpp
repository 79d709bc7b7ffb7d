#include "gui/operations/corner_plan_operations.h"

#include "gui/models/plan_fit.h"
#include "gui/models/preferences.h"
#include "gui/operations/actions.h"
#include "gui/operations/scene_editor.h"
#include "gui/session/session.h"
#include "gui/view/corner_plan.h"
#include "gui/view/frame_view.h"
#include "gui/view/input_capture.h"

#include "rtcore/platform/error.h"

#include <chrono>
#include <utility>

namespace gui {

namespace {

constexpr auto kAfterChanges = std::chrono::milliseconds(300);

std::optional<app::ToldOutline> outlineOf(const QString& text) {
    try {
        return app::parseOutline(text.toStdString());
    } catch (const rtcore::FileError&) {
        return std::nullopt;
    }
}

} // namespace

CornerPlanOperations::CornerPlanOperations(const GuiContext& context, QObject* parent)
    : QObject(parent), context_(context), plan_(new CornerPlan(context.view)) {
    plan_->hide();
    context_.actions.bind(ActionId::PlanInCorner, pref::planInCorner);
    changed_.setSingleShot(true);
    changed_.setInterval(kAfterChanges);
    connect(&changed_, &QTimer::timeout, this, &CornerPlanOperations::ask);
    connect(plan_, &CornerPlan::storeyWanted, this, &CornerPlanOperations::choose);
    connect(plan_, &CornerPlan::goWanted, this, &CornerPlanOperations::go);
    connect(plan_, &CornerPlan::lookWanted, this, &CornerPlanOperations::look);
    connect(&context_.preferences, &Preferences::changed, this, &CornerPlanOperations::showPlan);
    connect(&context_.session, &Session::stateChanged, this, &CornerPlanOperations::showPlan);
    connect(&context_.session, &Session::frameChanged, this, [this] {
        showPlan();
        follow();
    });
    // A camera may pass a storey without a frame that is shown.
    connect(&context_.session, &Session::statusChanged, this, &CornerPlanOperations::follow);
    connect(&context_.editor, &SceneEditor::sceneChanged, this, &CornerPlanOperations::forget);
    connect(&context_.editor, &SceneEditor::stateChanged, this, [this] {
        if (!plan_->isHidden()) changed_.start();
    });
    connect(&context_.view.input(), &InputCapture::capturedChanged, plan_, [plan = plan_](bool captured) {
        plan->setAttribute(Qt::WA_TransparentForMouseEvents, captured);
    });
    addStoreys();
}

void CornerPlanOperations::addStoreys() {
    context_.actions.on(ActionId::GroundFloor, [this] {
        goToStorey([metre = double{context_.editor.state().metresPerUnit}](const app::ToldOutline& outline) {
            std::vector<double> floors = outline.floors;
            for (double& floor : floors) floor *= metre;
            return groundFloor(floors);
        });
    });
    for (const auto& [id, by] : {std::pair{ActionId::StoreyAbove, 1}, std::pair{ActionId::StoreyBelow, -1}}) {
        context_.actions.on(id, [this, by] {
            goToStorey([by](const app::ToldOutline& outline) { return outline.storey + by; });
        });
    }
}

void CornerPlanOperations::showPlan() {
    const bool shows = context_.preferences.get(pref::planInCorner) && context_.session.live() &&
                       !context_.session.frame().isNull();
    if (shows != plan_->isHidden()) return;
    plan_->setVisible(shows);
    if (!shows) return changed_.stop();
    plan_->raise();
    wanted_.reset();
    byHand_ = false;
    ask();
}

void CornerPlanOperations::forget() {
    wanted_.reset();
    byHand_ = false;
    text_.clear();
    plan_->setMessage(tr("The plan is being made…"));
    ask();
}

// What is shown stays until the answer is there.
void CornerPlanOperations::ask() {
    if (plan_->isHidden() || !context_.session.live()) return;
    again_ = asks_;
    if (std::exchange(asks_, true)) return;
    context_.session.send(wanted_ ? command::planOutline(*wanted_) : command::planOutline(), this,
                          [this](const Answer& answer) {
                              asks_ = false;
                              answer.done ? take(answer.text) : refuse(answer.text);
                              if (std::exchange(again_, false)) ask();
                          });
}

// A storey that is there no more gives way to that of the camera.
void CornerPlanOperations::refuse(const QString& text) {
    text_.clear();
    if (wanted_) {
        again_ = true;
    } else {
        plan_->setMessage(text);
    }
    wanted_.reset();
    byHand_ = false;
}

void CornerPlanOperations::take(const QString& text) {
    if (std::exchange(text_, text) != text) {
        const std::optional<app::ToldOutline> outline = outlineOf(text);
        if (!outline) return plan_->setMessage(tr("The plan cannot be read."));
        plan_->setOutline(*outline);
    }
    follow();
}

int CornerPlanOperations::storeyOfCamera() const {
    const View& view = context_.session.status().view;
    const app::ToldOutline& outline = plan_->outline();
    return app::storeyAt(outline.floors, outline.top, heightOf(positionOf(view.eye, view), outline));
}

// A camera that comes to another storey shows that.
void CornerPlanOperations::follow() {
    if (plan_->isHidden()) return;
    const int storey = storeyOfCamera();
    if (storey != std::exchange(storey_, storey)) byHand_ = false;
    plan_->setView(context_.session.status().view, storey);
    if (!byHand_ && storey > 0) want(storey);
}

void CornerPlanOperations::want(int storey) {
    // What is on its way is another one.
    if (std::exchange(wanted_, storey) != storey && (asks_ || storey != plan_->outline().storey)) ask();
}

void CornerPlanOperations::choose(int storey) {
    byHand_ = true;
    want(storey);
}

// An edit, which can be undone.
void CornerPlanOperations::go(const std::array<double, 3>& eye) {
    const View& view = context_.session.status().view;
    context_.editor.edit(command::cameraSet(eye, numbersOf(view.forward)));
}

void CornerPlanOperations::look(const std::array<float, 3>& forward, bool goesOn) {
    const View& view = context_.session.status().view;
    context_.editor.follow(QStringLiteral("camera set"),
                           command::cameraSet(positionOf(view.eye, view), forward), goesOn);
}

// The server knows the storeys by now, or finds them in the background.
void CornerPlanOperations::goToStorey(const std::function<int(const app::ToldOutline&)>& choose) {
    context_.session.send(command::planOutline(), this, [this, choose](const Answer& answer) {
        const auto outline = answer.done ? outlineOf(answer.text) : std::nullopt;
        if (!outline) return context_.view.tell(answer.text);
        const int count = static_cast<int>(outline->floors.size()), storey = choose(*outline);
        if (count == 0) return context_.view.tell(tr("This model has no storeys."));
        if (storey < 1) return context_.view.tell(tr("This is the lowest storey."));
        if (storey > count) return context_.view.tell(tr("This is the highest storey."));
        context_.editor.edit(command::storeyGo(storey), [this, storey, count](const Answer& gone) {
            context_.view.tell(gone.done ? tr("Storey %1 of %2").arg(storey).arg(count) : gone.text);
        });
    });
}

} // namespace gui
