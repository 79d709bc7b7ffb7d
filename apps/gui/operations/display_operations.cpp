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

DisplayOperations::DisplayOperations(const Desk& desk, QObject* parent) : QObject(parent), desk_(desk) {
    Actions& actions = desk_.actions;
    actions.bind(ActionId::IgnoreAspectRatio, pref::ignoreAspectRatio);
    actions.bind(ActionId::SmoothTransformation, pref::smoothTransformation);
    actions.bind(ActionId::ShowOverlay, pref::showOverlay);
    actions.onToggle(ActionId::FullScreen, [this](bool on) { desk_.fullScreen.set(on); });
    connect(&desk_.fullScreen, &FullScreen::changed, actions[ActionId::FullScreen], &QAction::setChecked);
    actions.on(ActionId::Configure, [this] { configure(); });
    actions.on(ActionId::Keys, [this] { showKeys(); });
    actions.on(ActionId::About, [this] { (new AboutDialog(&desk_.window))->open(); });
    actions.on(ActionId::Statistics, [this] { showStatistics(); });
    connect(&desk_.preferences, &Preferences::changed, this, &DisplayOperations::applyPreferences);
    connect(&desk_.view, &FrameView::resolutionWanted, this, &DisplayOperations::askForResolution);
    applyPreferences();
}

void DisplayOperations::applyPreferences() {
    const Preferences& preferences = desk_.preferences;
    desk_.view.setIgnoreAspectRatio(preferences.get(pref::ignoreAspectRatio));
    desk_.view.setSmoothTransformation(preferences.get(pref::smoothTransformation));
    desk_.view.setShowFigures(preferences.get(pref::showOverlay));
    desk_.view.input().setMouseSensitivity(preferences.get(pref::mouseSensitivity),
                                           preferences.get(pref::invertMouse));
    if (theme_ == preferences.get(pref::theme)) return;
    theme_ = preferences.get(pref::theme);
    useTheme(theme_);
}

void DisplayOperations::askForResolution(const QSize& devicePixels) {
    if (!desk_.session.live() || !desk_.preferences.get(pref::followWindowSize)) return;
    const QSize wanted = devicePixels * desk_.preferences.get(pref::pictureScale) / 100;
    if (wanted.isEmpty() || wanted == desk_.session.status().resolution) return;
    desk_.session.send(command::resolution(wanted.width(), wanted.height()));
}

void DisplayOperations::configure() {
    const int scale = desk_.preferences.get(pref::pictureScale);
    const int time = desk_.preferences.get(pref::frameTime);
    auto* dialog = new ConfigureDialog(desk_.preferences, desk_.session, &desk_.window);
    connect(dialog, &QDialog::accepted, this, [this, scale, time] {
        if (desk_.preferences.get(pref::pictureScale) != scale) askForResolution(desk_.view.devicePixels());
        const int now = desk_.preferences.get(pref::frameTime);
        if (now == time || !desk_.keeper.ours()) return;
        desk_.session.send(command::frameTime(now));
    });
    dialog->open();
}

void DisplayOperations::showKeys() {
    if (keys_ == nullptr) keys_ = new KeysDialog(desk_.session, &desk_.window);
    present(*keys_);
}

void DisplayOperations::showStatistics() {
    if (statistics_ == nullptr)
        statistics_ = new StatisticsDialog(
            desk_.session, [this] { return desk_.view.paintDelay(); }, &desk_.window);
    present(*statistics_);
}

} // namespace gui
