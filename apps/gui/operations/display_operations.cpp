#include "gui/operations/display_operations.h"

#include "gui/dialogs/about_dialog.h"
#include "gui/dialogs/configure_dialog.h"
#include "gui/dialogs/keys_dialog.h"
#include "gui/dialogs/statistics_dialog.h"
#include "gui/operations/actions.h"
#include "gui/processes/server_keeper.h"
#include "gui/session/session.h"
#include "gui/view/frame_view.h"
#include "gui/view/full_screen.h"
#include "gui/view/input_capture.h"
#include "gui/view/theme.h"

#include <QAction>

namespace gui {

namespace {

// One of each kind, in front.
void present(QDialog& dialog) {
    dialog.show();
    dialog.raise();
    dialog.activateWindow();
}

} // namespace

DisplayOperations::DisplayOperations(const GuiContext& context, QObject* parent)
    : QObject(parent), context_(context) {
    Actions& actions = context_.actions;
    actions.bind(ActionId::IgnoreAspectRatio, pref::ignoreAspectRatio);
    actions.bind(ActionId::SmoothTransformation, pref::smoothTransformation);
    actions.bind(ActionId::ShowOverlay, pref::showOverlay);
    actions.bind(ActionId::ShowErrors, pref::showErrors);
    actions.onToggle(ActionId::FullScreen, [this](bool on) { context_.fullScreen.set(on); });
    connect(&context_.fullScreen, &FullScreen::changed, actions[ActionId::FullScreen], &QAction::setChecked);
    actions.on(ActionId::Configure, [this] { configure(); });
    actions.on(ActionId::Keys, [this] { showKeys(); });
    actions.on(ActionId::About, [this] { (new AboutDialog(&context_.window))->open(); });
    actions.on(ActionId::Statistics, [this] { showStatistics(); });
    connect(&context_.preferences, &Preferences::changed, this, &DisplayOperations::applyPreferences);
    connect(&context_.view, &FrameView::resolutionWanted, this, &DisplayOperations::askForResolution);
    applyPreferences();
}

void DisplayOperations::applyPreferences() {
    const Preferences& preferences = context_.preferences;
    context_.view.setIgnoreAspectRatio(preferences.get(pref::ignoreAspectRatio));
    context_.view.setSmoothTransformation(preferences.get(pref::smoothTransformation));
    context_.view.setShowOverlay(preferences.get(pref::showOverlay));
    context_.view.setShowErrors(preferences.get(pref::showErrors));
    context_.view.input().setMouseSensitivity(preferences.get(pref::mouseSensitivity),
                                              preferences.get(pref::invertMouse));
    context_.view.input().setMouseScheme(mouseSchemeNamed(preferences.get(pref::mouse)));
    if (theme_ == preferences.get(pref::theme)) return;
    theme_ = preferences.get(pref::theme);
    useTheme(theme_);
}

void DisplayOperations::askForResolution(const QSize& devicePixels) {
    if (!context_.session.live() || !context_.preferences.get(pref::followWindowSize)) return;
    const QSize wanted = devicePixels * context_.preferences.get(pref::pictureScale) / 100;
    if (wanted.isEmpty() || wanted == context_.session.status().resolution) return;
    context_.session.send(command::resolution(wanted.width(), wanted.height()));
}

void DisplayOperations::configure() {
    const int scale = context_.preferences.get(pref::pictureScale);
    const int time = context_.preferences.get(pref::frameTime);
    auto* dialog = new ConfigureDialog(context_.preferences, context_.session, &context_.window);
    connect(dialog, &QDialog::accepted, this, [this, scale, time] {
        if (context_.preferences.get(pref::pictureScale) != scale)
            askForResolution(context_.view.devicePixels());
        const int now = context_.preferences.get(pref::frameTime);
        if (now == time || !context_.keeper.ours()) return;
        context_.session.send(command::frameTime(now));
    });
    dialog->open();
}

void DisplayOperations::showKeys() {
    const ShortcutScheme scheme = shortcutSchemeOf(context_.preferences.get(pref::shortcuts));
    const MouseScheme mouse = mouseSchemeNamed(context_.preferences.get(pref::mouse));
    if (keys_ == nullptr) keys_ = new KeysDialog(context_.session, scheme, mouse, &context_.window);
    present(*keys_);
}

void DisplayOperations::showStatistics() {
    if (statistics_ == nullptr)
        statistics_ = new StatisticsDialog(
            context_.session, [this] { return context_.view.paintDelay(); },
            [this] {
                const FrameView& view = context_.view;
                return view.showsLive() ? tr("live") : originText(view.origin());
            },
            &context_.window);
    present(*statistics_);
}

} // namespace gui
