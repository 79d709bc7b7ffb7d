#include "gui/operations/share_operations.h"

#include "gui/dialogs/share_dialog.h"
#include "gui/operations/actions.h"
#include "gui/processes/server_keeper.h"
#include "gui/session/session.h"
#include "gui/view/frame_view.h"
#include "gui/view/notice_bar.h"

#include <QAction>

#include <utility>

namespace gui {

ShareOperations::ShareOperations(const GuiContext& context, QObject* parent)
    : QObject(parent), context_(context) {
    context_.actions.on(ActionId::ShareInBrowser, [this] { showDialog(); });
    connect(&bridge_, &BridgeProcess::linksChanged, this, &ShareOperations::onLinks);
    connect(&bridge_, &BridgeProcess::ended, this, &ShareOperations::onEnded);
    connect(&watch_, &BridgeWatch::visitorsChanged, this, &ShareOperations::showState);
    connect(&context_.session, &Session::stateChanged, this, &ShareOperations::onState);
    onState();
}

void ShareOperations::showDialog() {
    showState(); // the click has changed the check mark
    if (dialog_ == nullptr) {
        dialog_ = new ShareDialog(context_.preferences, ownAddresses(), &context_.window);
        connect(dialog_, &ShareDialog::startWanted, this, &ShareOperations::start);
        connect(dialog_, &ShareDialog::stopWanted, &bridge_, &BridgeProcess::stop);
        connect(&dialog_->links(), &ShareLinksPage::openWanted, this, &ShareOperations::open);
        fillDialog();
    }
    dialog_->show();
    dialog_->raise();
    dialog_->activateWindow();
}

void ShareOperations::fillDialog() {
    if (!bridge_.running()) return;
    if (bridge_.links().viewer.isEmpty()) return dialog_->showStarting();
    dialog_->showLinks(bridge_.request(), bridge_.links());
    dialog_->links().show(watch_.visitors());
}

void ShareOperations::start(BridgeRequest request) {
    if (bridge_.running()) return;
    request.instance = context_.session.instance();
    bridge_.start(request);
    if (dialog_ != nullptr) fillDialog();
}

void ShareOperations::open(const QString& link) {
    const bool opened = opener_.open(link);
    if (dialog_ == nullptr) return;
    dialog_->links().tell(opened ? tr("The browser opens the page.")
                                 : tr("No browser could be started; copy the link."));
}

void ShareOperations::onLinks() {
    context_.keeper.setCompanion(bridge_.process());
    watch_.start(bridge_.links().viewer);
    if (dialog_ != nullptr) fillDialog();
    showState();
}

void ShareOperations::onEnded(const QString& text) {
    context_.keeper.setCompanion(0);
    watch_.stop();
    opener_.forget();
    showState();
    if (dialog_ != nullptr) return dialog_->showPlan(text);
    if (!text.isEmpty())
        context_.notice.explain(tr("The server is no longer shared in browsers: %1").arg(text),
                                {context_.actions[ActionId::ShareInBrowser]});
}

bool ShareOperations::serverStays() const {
    const Session& session = context_.session;
    const QString& instance = bridge_.request().instance;
    return (session.live() && session.instance() == instance) || context_.keeper.mayComeBack(instance);
}

void ShareOperations::onState() {
    if (bridge_.running() && !serverStays()) bridge_.stop();
    showState();
}

void ShareOperations::showState() {
    const bool shared = !bridge_.links().viewer.isEmpty();
    QAction& action = *context_.actions[ActionId::ShareInBrowser];
    action.setChecked(shared);
    action.setEnabled(context_.session.live() || bridge_.running());
    const qsizetype visitors = watch_.visitors().size();
    context_.view.setSharing(!shared        ? QString()
                             : visitors > 0 ? tr("● shared: %1").arg(visitors)
                                            : tr("● shared"));
    if (dialog_ != nullptr) dialog_->links().show(watch_.visitors());
}

} // namespace gui
