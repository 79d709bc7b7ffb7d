#include "gui/operations/motion_operations.h"

#include "gui/models/bindings.h"
#include "gui/processes/server_keeper.h"
#include "gui/session/session.h"
#include "gui/view/frame_view.h"
#include "gui/view/input_capture.h"

#include <QLocale>

#include <algorithm>
#include <cmath>
#include <utility>

namespace gui {

namespace {

constexpr double kStepsPerDoubling = 2;
constexpr double kMostWheelSteps = 12;

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
    connect(&session, &Session::stateChanged, this, [this](SessionState state) {
        if (state == SessionState::Connecting) steps_ = 0;
        if (!context_.session.live()) context_.view.input().release();
        if (!std::exchange(live_, context_.session.live()) && live_) askForBindings();
    });
    connect(&input, &InputCapture::capturedChanged, this, [this](bool captured) {
        if (captured && context_.session.live()) askForBindings();
    });
}

// Any program may change them.
void MotionOperations::askForBindings() {
    context_.session.send(command::bindings(), this, [this](const Answer& answer) {
        if (answer.done) context_.view.input().setBindings(readBindings(answer.text));
    });
}

void MotionOperations::changeSpeed(double steps) {
    if (!context_.session.live()) return;
    steps_ = std::clamp(steps_ + steps, -kMostWheelSteps, kMostWheelSteps);
    const double factor = std::exp2(steps_ / kStepsPerDoubling);
    context_.session.send(command::speed(factor));
    const QString text = context_.session.status().view.walking
                             ? tr("Flying speed × %1; walking keeps its own")
                             : tr("Flying speed × %1");
    context_.view.tell(text.arg(QLocale().toString(factor, 'g', 2)));
}

} // namespace gui
