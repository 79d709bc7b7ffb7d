#include "gui/operations/motion_operations.h"

#include "gui/models/bindings.h"
#include "gui/operations/actions.h"
#include "gui/operations/scene_editor.h"
#include "gui/operations/to_middle.h"
#include "gui/processes/server_keeper.h"
#include "gui/session/session.h"
#include "gui/view/frame_view.h"
#include "gui/view/input_capture.h"

#include <QAction>
#include <QLocale>

#include <algorithm>
#include <cmath>
#include <utility>

namespace gui {

namespace {

constexpr double kStepsPerDoubling = 2;
constexpr double kMaxWheelSteps = 12;
constexpr double kHalfTurn = 180;     ///< degrees
constexpr double kNearer = 1.2;       ///< by a step of the wheel
constexpr double kPixelsPerStep = 15; ///< of a drag that goes nearer

struct Side {
    ActionId action;
    const char* name;
};
constexpr Side kSides[]{{ActionId::ViewFront, "front"},
                        {ActionId::ViewBack, "back"},
                        {ActionId::ViewLeft, "left"},
                        {ActionId::ViewRight, "right"},
                        {ActionId::ViewTop, "top"},
                        {ActionId::ViewBottom, "bottom"},
                        {ActionId::ViewThreeQuarter, "three-quarter"}};

} // namespace

MotionOperations::MotionOperations(const GuiContext& context, QObject* parent)
    : QObject(parent), context_(context) {
    InputCapture& input = context_.view.input();
    Session& session = context_.session;
    connect(&input, &InputCapture::keyPressed, &session, &Session::pressKey);
    connect(&input, &InputCapture::keyReleased, &session, &Session::releaseKey);
    connect(&input, &InputCapture::allKeysReleased, &session, &Session::releaseAllKeys);
    connect(&input, &InputCapture::turned, &session, &Session::turn);
    connect(&input, &InputCapture::wheelTurned, this, &MotionOperations::changeSpeed);
    bindOrbit();
    connect(&session, &Session::stateChanged, this, [this](SessionState state) {
        if (state == SessionState::Connecting) steps_ = 0;
        if (!context_.session.live()) context_.view.input().release();
        if (!std::exchange(live_, context_.session.live()) && live_) askForBindings();
    });
    connect(&input, &InputCapture::capturedChanged, this, [this](bool captured) {
        if (captured && context_.session.live()) askForBindings();
    });
}

// The model turns in the hand: all of the image's width is half a turn.
void MotionOperations::bindOrbit() {
    InputCapture& input = context_.view.input();
    Session& session = context_.session;
    connect(&input, &InputCapture::grasped, this, &MotionOperations::takeHold);
    connect(&input, &InputCapture::dragged, this, [this, &session](const QPointF& by) {
        const double degrees = kHalfTurn / std::max(context_.view.pictureArea().width(), 1.0);
        session.orbit(by.x() * degrees, -by.y() * degrees);
    });
    connect(&input, &InputCapture::pushed, this, [this, &session](const QPointF& by) {
        const double width = std::max(context_.view.pictureArea().width(), 1.0);
        session.pan(by.x() / width, -by.y() / width);
    });
    connect(&input, &InputCapture::neared, this,
            [&session](double by) { session.approach(std::pow(kNearer, by / kPixelsPerStep)); });
    connect(&input, &InputCapture::reached, this, [this, &session](const QPointF& position, double steps) {
        takeHold(position);
        session.approach(std::pow(kNearer, steps));
    });
    connect(&input, &InputCapture::centred, this,
            [this](const QPointF& position) { bringToMiddle(context_, position); });
    context_.actions.on(ActionId::FitView, [this] { context_.editor.edit(command::cameraFit()); });
    for (const auto& [id, side] : kSides)
        context_.actions.on(id, [this, side] { context_.editor.edit(command::cameraView(side)); });
}

void MotionOperations::takeHold(const QPointF& position) {
    if (const auto place = context_.view.inPicture(position))
        context_.session.takeHold((place->x() + 1) / 2, (1 - place->y()) / 2);
}

// Any program may change them.
void MotionOperations::askForBindings() {
    context_.session.send(command::bindings(), this, [this](const Answer& answer) {
        if (answer.done) context_.view.input().setBindings(readBindings(answer.text));
    });
}

void MotionOperations::changeSpeed(double steps) {
    if (!context_.session.live()) return;
    steps_ = std::clamp(steps_ + steps, -kMaxWheelSteps, kMaxWheelSteps);
    const double factor = std::exp2(steps_ / kStepsPerDoubling);
    context_.session.send(command::speed(factor));
    const QString text = context_.session.status().view.walking
                             ? tr("Flying speed × %1; walking keeps its own")
                             : tr("Flying speed × %1");
    context_.view.tell(text.arg(QLocale().toString(factor, 'g', 2)));
}

} // namespace gui
