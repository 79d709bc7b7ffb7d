#include "gui/operations/message_operations.h"

#include "gui/dialogs/log_dialog.h"
#include "gui/operations/actions.h"
#include "gui/operations/scene_editor.h"
#include "gui/processes/server_keeper.h"
#include "gui/session/session.h"
#include "gui/view/frame_view.h"
#include "gui/view/notice_bar.h"

#include <utility>

namespace gui {

MessageOperations::MessageOperations(const Desk& desk, QObject* parent) : QObject(parent), desk_(desk) {
    desk_.actions.on(ActionId::ServerLog, [this] { showLog(); });
    connect(&desk_.session, &Session::stateChanged, this, &MessageOperations::onState);
    connect(&desk_.session, &Session::statusChanged, this, &MessageOperations::onStatus);
    connect(&desk_.editor, &SceneEditor::sceneChanged, this, &MessageOperations::onScene);
}

void MessageOperations::onState() {
    if (std::exchange(live_, desk_.session.live()) == desk_.session.live() || !live_) return;
    known_ = 0;
    before_ = desk_.session.status().messages;
    asking_ = false;
    heard_.clear();
    warnings_.clear();
    onStatus();
}

void MessageOperations::onStatus() {
    if (!live_ || asking_ || desk_.session.status().messages <= known_) return;
    asking_ = true;
    desk_.session.send(command::messages(static_cast<std::uint32_t>(known_)), this,
                       [this](const Answer& answer) {
                           asking_ = false;
                           if (!answer.done) return;
                           take(readMessages(answer.text));
                           onStatus();
                       });
}

// What keys did before we came is over; the warnings still hold.
void MessageOperations::take(const QList<Message>& messages) {
    QStringList warnings;
    for (const Message& message : messages) {
        known_ = message.number;
        heard_.append(message.text);
        if (message.warning) warnings.append(message.text);
        if (!message.warning && message.number > before_) desk_.view.tell(eventText(message.text));
    }
    if (messages.isEmpty()) known_ = desk_.session.status().messages; // forgotten: another scene came
    warn(warnings);
}

// A kept model is not imported again: the server knows of no warnings.
void MessageOperations::onScene() {
    if (!desk_.keeper.ours()) return;
    const QStringList warnings = desk_.keeper.models().warnings(desk_.editor.scene());
    heard_ += warnings;
    warn(warnings);
}

void MessageOperations::warn(const QStringList& warnings) {
    if (warnings.isEmpty()) return;
    if (!desk_.notice.isVisible()) warnings_.clear();
    for (const QString& warning : warnings) {
        if (!warnings_.contains(warning)) warnings_.append(warning);
    }
    desk_.notice.explain(warningsText(warnings_), {desk_.actions[ActionId::ServerLog]});
}

// What a server of ours has printed outlives it.
void MessageOperations::showLog() {
    auto* dialog = new LogDialog(
        [this] {
            const bool anothers = desk_.session.live() && !desk_.keeper.ours();
            const QString log = anothers ? QString() : desk_.keeper.server().log();
            QStringList lines = log.split(QLatin1Char('\n'), Qt::SkipEmptyParts);
            for (const QString& each : heard_) {
                if (!log.contains(each)) lines.append(each);
            }
            return lines.join(QLatin1Char('\n'));
        },
        &desk_.window);
    dialog->show();
}

} // namespace gui
