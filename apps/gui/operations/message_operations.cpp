#include "gui/operations/message_operations.h"

#include "gui/dialogs/log_dialog.h"
#include "gui/operations/actions.h"
#include "gui/operations/scene_editor.h"
#include "gui/processes/server_keeper.h"
#include "gui/session/session.h"
#include "gui/view/frame_view.h"
#include "gui/view/notice_bar.h"

#include "common/commands/command_lines.h"

#include <QAction>

#include <utility>

namespace gui {

MessageOperations::MessageOperations(const GuiContext& context, QObject* parent)
    : QObject(parent), context_(context), turn_(new QAction(this)), takeBack_(new QAction(tr("Undo"), this)),
      darken_(new QAction(tr("Switch Them Off"), this)) {
    connect(turn_, &QAction::triggered, this, [this] {
        if (!upOffer_) return;
        context_.editor.edit(app::command::up(upOffer_->other.toStdString()));
        upOffer_.reset();
    });
    connect(takeBack_, &QAction::triggered, this, [this] {
        context_.editor.edit(app::command::materialReset("*"));
        materialOffer_.clear();
    });
    connect(darken_, &QAction::triggered, this, [this] {
        if (fillOffer_) switchOff(fillOffer_->lights);
        fillOffer_.reset();
    });
    context_.actions.on(ActionId::ServerLog, [this] { showLog(); });
    connect(&context_.session, &Session::stateChanged, this, &MessageOperations::onState);
    connect(&context_.session, &Session::statusChanged, this, &MessageOperations::onStatus);
}

void MessageOperations::onState() {
    if (std::exchange(live_, context_.session.live()) == context_.session.live()) return;
    if (!live_) return hideNotice();
    known_ = 0;
    before_ = context_.session.status().messages;
    asking_ = false;
    heard_.clear();
    warnings_.clear();
    forgetOffers();
    onStatus();
}

void MessageOperations::onStatus() {
    if (!live_ || asking_ || context_.session.status().messages <= known_) return;
    asking_ = true;
    context_.session.send(command::messages(static_cast<std::uint32_t>(known_)), this,
                          [this](const Answer& answer) {
                              asking_ = false;
                              if (!answer.done) return;
                              take(readMessages(answer.text, answer.detail));
                              onStatus();
                          });
}

// Events of keys from before we came are over; the warnings still hold.
void MessageOperations::take(const QList<Message>& messages) {
    QStringList warnings;
    for (const Message& message : messages) {
        known_ = message.number;
        heard_.append(message.shown());
        if (message.offer) offer(message);
        if (message.offer) continue;
        if (message.warning) warnings.append(message.shown());
        if (!message.warning && message.number > before_) context_.view.tell(eventText(message));
    }
    if (messages.isEmpty()) known_ = context_.session.status().messages; // forgotten: another scene came
    warn(warnings);
}

void MessageOperations::warn(const QStringList& warnings) {
    if (warnings.isEmpty()) return;
    forgetClosed();
    for (const QString& warning : warnings) {
        if (!warnings_.contains(warning)) warnings_.append(warning);
    }
    notify();
}

void MessageOperations::offer(const Message& message) {
    const std::optional<UpOffer> up = readUpOffer(message);
    const std::optional<QString> unit = readUnitOffer(message);
    const std::optional<QString> materials = readMaterialOffer(message);
    const std::optional<FillOffer> fill = readFillOffer(message);
    if (!up && !unit && !materials && !fill) return;
    forgetClosed();
    if (materials) materialOffer_ = *materials;
    if (up) {
        upOffer_ = up;
        turn_->setText(tr("%1 is up").arg(up->other.toUpper()));
    }
    if (unit) unitOffer_ = *unit;
    if (fill) fillOffer_ = fill;
    notify();
}

// As one edit.
void MessageOperations::switchOff(const QList<int>& lights) {
    for (qsizetype i = 0; i < lights.size(); ++i) {
        const std::string line = app::command::light(lights[i], false);
        context_.editor.edit(i == 0 ? line : app::command::also(line));
    }
}

void MessageOperations::forgetOffers() {
    fillOffer_.reset();
    upOffer_.reset();
    unitOffer_.clear();
    materialOffer_.clear();
}

void MessageOperations::forgetClosed() {
    if (context_.notice.isVisible()) return;
    warnings_.clear();
    forgetOffers();
}

void MessageOperations::notify() {
    QStringList lines;
    QList<QAction*> actions;
    if (upOffer_) {
        lines.append(upOffer_->text);
        actions.append(turn_);
    }
    if (!unitOffer_.isEmpty()) {
        lines.append(unitOffer_);
        actions.append(context_.actions[ActionId::UpAndUnit]);
    }
    if (!materialOffer_.isEmpty()) {
        lines.append(materialOffer_);
        actions.append(takeBack_);
    }
    if (fillOffer_) {
        lines.append(fillOffer_->text);
        actions.append(darken_);
    }
    if (!warnings_.isEmpty()) {
        lines.append(warningsText(warnings_));
        actions.append(context_.actions[ActionId::ServerLog]);
    }
    shown_ = lines.join(QLatin1Char('\n'));
    context_.notice.explain(shown_, actions);
}

// A notice of other operations stays.
void MessageOperations::hideNotice() {
    if (!shown_.isEmpty() && context_.notice.text() == shown_) context_.notice.hide();
    shown_.clear();
}

// The log of a server of ours outlives it.
void MessageOperations::showLog() {
    auto* dialog = new LogDialog(
        [this] {
            const bool anothers = context_.session.live() && !context_.keeper.ours();
            const QString log = anothers ? QString() : context_.keeper.server().log();
            QStringList lines = log.split(QLatin1Char('\n'), Qt::SkipEmptyParts);
            for (const QString& each : heard_) {
                if (!log.contains(each)) lines.append(each);
            }
            return lines.join(QLatin1Char('\n'));
        },
        &context_.window);
    dialog->show();
}

} // namespace gui
