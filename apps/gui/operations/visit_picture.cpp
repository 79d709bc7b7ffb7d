#include "gui/operations/visit_picture.h"

#include "gui/session/session.h"
#include "gui/view/frame_view.h"

#include <utility>

namespace gui {

namespace {

constexpr QSize kPicture{320, 200}; ///< sharp on a screen of twice the density, too

} // namespace

QImage smallPicture(const GuiContext& context) {
    const QImage seen = context.view.shown();
    return seen.isNull() ? seen : seen.scaled(kPicture, Qt::KeepAspectRatio, Qt::SmoothTransformation);
}

VisitPicture::VisitPicture(const GuiContext& context, QObject* parent) : QObject(parent), context_(context) {
    connect(&context_.session, &Session::statusChanged, this, &VisitPicture::onStatus);
}

void VisitPicture::begin(Take take) {
    take_ = std::move(take);
    camera_.reset();
    asks_ = false;
    context_.session.send(command::cameraGet(), this, [this, visit = ++visit_](const Answer& answer) {
        if (visit != visit_) return;
        if (!answer.done) take_ = {};
        camera_ = answer.text;
        onStatus();
    });
}

// Complete means that the next frame would equal the one that is there.
void VisitPicture::onStatus() {
    const ServerStatus& status = context_.session.status();
    if (!take_ || !camera_ || asks_ || !status.idle || status.paused) return;
    asks_ = true;
    context_.session.send(command::cameraGet(), this, [this, visit = visit_](const Answer& answer) {
        if (visit != visit_ || !take_) return;
        asks_ = false;
        const bool stayed = answer.done && answer.text == *camera_;
        if (stayed && !context_.session.status().idle) return; // the status was of before
        const Take take = std::exchange(take_, {});
        if (stayed) take(smallPicture(context_));
    });
}

} // namespace gui
