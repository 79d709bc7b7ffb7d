#include "gui/operations/recording_operations.h"

#include "gui/models/output_file.h"
#include "gui/models/preferences.h"
#include "gui/operations/actions.h"
#include "gui/session/session.h"
#include "gui/view/frame_view.h"
#include "gui/view/notice_bar.h"
#include "gui/view/recording_mark.h"

#include <QAction>

namespace gui {

RecordingOperations::RecordingOperations(const GuiContext& context, QObject* parent)
    : QObject(parent), context_(context), mark_(new RecordingMark(context.view)) {
    context_.actions.on(ActionId::RecordWalk, [this] { toggle(); });
    context_.actions[ActionId::RecordWalk]->setAutoRepeat(false); // a key that is held is pressed once
    connect(&context_.session, &Session::statusChanged, this, &RecordingOperations::onStatus);
    connect(&context_.session, &Session::stateChanged, this, &RecordingOperations::onStatus);
}

// Its tick is what the server does.
void RecordingOperations::toggle() {
    context_.actions[ActionId::RecordWalk]->setChecked(recording_);
    const auto tell = [this](const Answer& answer) {
        if (answer.done) return;
        byKey_ = false;
        context_.notice.explain(answer.text, {});
    };
    if (recording_) return context_.session.send(command::exportVideoStop(), this, tell);
    byKey_ = true;
    const QString list =
        nextFreeName(context_.preferences.picturesFolder(), QStringLiteral("walk"), QStringLiteral("lst"));
    context_.session.send(command::exportVideoStart(list.toStdString()), this, tell);
}

void RecordingOperations::onStatus() {
    const bool recording = context_.session.live() && context_.session.status().recording;
    if (recording == recording_) return;
    recording_ = recording;
    context_.actions[ActionId::RecordWalk]->setChecked(recording);
    if (!recording) mark_->stop();
    if (!context_.session.live()) return;
    context_.session.send(command::exportVideo(), this, [this](const Answer& answer) {
        if (answer.done) take(answer.text);
    });
}

// "on SECONDS LIST", "off LIST" or "off".
void RecordingOperations::take(const QString& answer) {
    if (answer.startsWith(QStringLiteral("on ")))
        return mark_->start(answer.section(QLatin1Char(' '), 1, 1).toDouble());
    const QString list = answer.section(QLatin1Char(' '), 1);
    if (byKey_ && !list.isEmpty()) context_.view.tell(tr("The walk was recorded in %1.").arg(list));
    byKey_ = false;
}

} // namespace gui
