#include "gui/operations/motion_operations.h"

#include "gui/processes/server_keeper.h"
#include "gui/session/session.h"
#include "gui/view/frame_view.h"
#include "gui/view/input_capture.h"

#include <QLocale>

#include <algorithm>
#include <cmath>

namespace gui {

namespace {

constexpr double kStepsPerDoubling = 2;
constexpr double kMostSteps = 12;

} // namespace

MotionOperations::MotionOperations(const Desk& desk, QObject* parent) : QObject(parent), desk_(desk) {
    InputCapture& input = desk_.view.input();
    Session& session = desk_.session;
    connect(&input, &InputCapture::keyPressed, &session, &Session::pressKey);
    connect(&input, &InputCapture::keyReleased, &session, &Session::releaseKey);
    connect(&input, &InputCapture::allKeysReleased, &session, &Session::releaseAllKeys);
    connect(&input, &InputCapture::turned, &session, &Session::turn);
    connect(&input, &InputCapture::wheelTurned, this, &MotionOperations::changeSpeed);
    connect(&session, &Session::stateChanged, this, [this](SessionState state) {
        if (state == SessionState::Connecting) steps_ = 0;
        if (!desk_.session.live()) desk_.view.input().release();
    });
}

void MotionOperations::changeSpeed(double steps) {
    if (!desk_.session.live()) return;
    steps_ = std::clamp(steps_ + steps, -kMostSteps, kMostSteps);
    const double factor = std::exp2(steps_ / kStepsPerDoubling);
    desk_.session.send(QStringLiteral("speed %1").arg(factor, 0, 'g', 6));
    desk_.view.tell(tr("Flying speed × %1").arg(QLocale().toString(factor, 'g', 2)));
}

} // namespace gui
