#include "gui/operations/render_operations.h"

#include "gui/models/at_rest.h"
#include "gui/operations/actions.h"
#include "gui/operations/scene_editor.h"
#include "gui/processes/server_keeper.h"
#include "gui/session/session.h"
#include "gui/view/frame_view.h"
#include "gui/view/input_capture.h"
#include "gui/view/notice_bar.h"

#include <QAction>
#include <QLocale>

#include <array>
#include <utility>

namespace gui {

namespace {

using namespace std::chrono_literals;

constexpr auto kRest = 250ms; ///< between two taps of a key nothing is started
constexpr auto kResize = 2s;  ///< a server that is asked for another size has it by then

} // namespace

RenderOperations::RenderOperations(const GuiContext& context, QObject* parent)
    : QObject(parent), context_(context), preview_(context.session, context.keeper.models()) {
    context_.actions.on(ActionId::QuickRender,
                        [this] { quickRender(context_.preferences.get(pref::stillAntialiasing)); });
    bindAtRest();
    rest_.setSingleShot(true);
    rest_.setInterval(kRest);
    listen();
}

void RenderOperations::bindAtRest() {
    constexpr std::array kActions{ActionId::AtRestLive, ActionId::AtRestRefined, ActionId::AtRestGlobal};
    const auto show = [this, kActions] {
        for (std::size_t i = 0; i < kActions.size(); ++i)
            context_.actions[kActions.at(i)]->setChecked(atRest(context_.preferences) == kAtRest.at(i));
    };
    for (std::size_t i = 0; i < kActions.size(); ++i) {
        context_.actions.on(kActions.at(i), [this, i, show] {
            toggleAtRest(context_.preferences, kAtRest.at(i));
            show(); // also where nothing changed
        });
    }
    connect(&context_.preferences, &Preferences::changed, this, show);
    show();
}

// The light that the server would learn for a view that rests alone is not seen where it is refined here.
void RenderOperations::tellServer() {
    refines_ = context_.preferences.get(pref::progressiveRendering);
    if (context_.session.live()) context_.session.send(app::command::restLight(refines_));
}

void RenderOperations::listen() {
    InputCapture& input = context_.view.input();
    connect(&input, &InputCapture::commandKey, this, [this](int code, bool withL) {
        if (code == 'R' && context_.session.live())
            quickRender(withL ? context_.preferences.get(pref::stillAntialiasing) : 1);
    });
    connect(&input, &InputCapture::keyPressed, this, &RenderOperations::interrupt);
    connect(&input, &InputCapture::turned, this, &RenderOperations::interrupt);
    connect(&context_.session, &Session::stateChanged, this, [this] {
        if (context_.session.live()) return tellServer();
        interrupt();
        preview_.leave();
    });
    connect(&context_.session, &Session::statusChanged, this, &RenderOperations::onStatus);
    connect(&context_.session, &Session::frameChanged, this, &RenderOperations::onFrame);
    connect(&context_.preferences, &Preferences::changed, this, &RenderOperations::onPreferences);
    connect(&context_.view, &FrameView::resolutionWanted, this, [this] {
        if (!keeps()) revision_ = context_.session.status().imageRevision;
        sizeAsked_.start();
    });
    connect(&context_.editor, &SceneEditor::sending, this, [this] {
        if (keeps()) interrupt();
    });
    connect(&rest_, &QTimer::timeout, this, &RenderOperations::renderProgressively);
    connect(&preview_, &PreviewProcess::refined, this, &RenderOperations::onRefined);
    connect(&preview_, &PreviewProcess::failed, this, &RenderOperations::onFailed);
    connect(&preview_, &PreviewProcess::progressed, this, &RenderOperations::showActivity);
}

// --- When ---

bool RenderOperations::mayRenderProgressively() const {
    const ServerStatus& status = context_.session.status();
    return context_.preferences.get(pref::progressiveRendering) && context_.session.live() && status.idle &&
           !status.paused && status.progress >= 1 && !context_.session.frame().isNull() &&
           context_.view.isVisible() && !context_.window.isMinimized();
}

void RenderOperations::renderProgressively() {
    if (settled_ || !mayRenderProgressively()) return;
    quick_ = false;
    render(stillQuality(context_.preferences));
}

void RenderOperations::quickRender(int antialiasing) {
    context_.view.showLive();
    quick_ = true;
    StillQuality quality = stillQuality(context_.preferences);
    quality.antialiasing = antialiasing;
    render(quality);
}

void RenderOperations::render(const StillQuality& quality) {
    rest_.stop();
    settled_ = true;
    const ServerStatus& status = context_.session.status();
    moment_ = {status.view, status.resolution, context_.session.frameNumber(), status.idle};
    rendered_ = quality;
    preview_.render(quality);
}

void RenderOperations::interrupt() {
    kept_.reset();
    sizeAsked_.invalidate();
    context_.view.showLive();
    beginAgain();
}

void RenderOperations::beginAgain() {
    preview_.cancel();
    settled_ = false;
    rest_.start();
    showActivity();
}

// As when a panel opens. The view is that of before, but for the angle, which follows the sides of the frame.
void RenderOperations::onResize() {
    const View before = std::exchange(moment_.view, context_.session.status().view);
    moment_.size = context_.session.status().resolution;
    const bool same = before.eye == moment_.view.eye && before.forward == moment_.view.forward &&
                      before.up == moment_.view.up;
    if (!same || context_.view.showsLive()) return interrupt();
    if (!keeps()) revision_ = context_.session.status().imageRevision;
    sizeAsked_.invalidate();
    kept_ = context_.view.origin();
    beginAgain();
}

bool RenderOperations::resizes() const {
    return sizeAsked_.isValid() && !sizeAsked_.hasExpired(std::chrono::milliseconds(kResize).count());
}

void RenderOperations::onStatus() {
    const ServerStatus& status = context_.session.status();
    if (keeps() && status.imageRevision != revision_) return interrupt();
    if ((settled_ || kept_) && status.resolution != moment_.size) return onResize();
    const bool moved = status.view != moment_.view;
    const bool busy = moment_.idle && !status.idle && !resizes();
    if (settled_ ? moved || busy : kept_ && moved) return interrupt();
    if (!settled_ && mayRenderProgressively() && !rest_.isActive()) rest_.start();
}

// A server at rest publishes nothing unless something has changed, be it for less time than it takes to see.
void RenderOperations::onFrame() {
    const bool another = context_.session.frameNumber() != moment_.frame;
    if (settled_ && moment_.idle && another && !resizes()) interrupt();
}

void RenderOperations::onPreferences() {
    if (refines_ != context_.preferences.get(pref::progressiveRendering)) tellServer();
    if (!quick_ && !context_.preferences.get(pref::progressiveRendering)) {
        if (settled_) interrupt();
        return preview_.leave();
    }
    const bool progressive = settled_ && !quick_;
    if (progressive && !(stillQuality(context_.preferences) == rendered_)) return interrupt();
    if (!settled_ && mayRenderProgressively()) rest_.start();
}

// --- Images and progress ---

void RenderOperations::onRefined(const QImage& picture, bool last, const PictureOrigin& origin,
                                 const QImage& errors) {
    const bool worse = kept_ && (origin.paths != kept_->paths || origin.samples < kept_->samples);
    if (worse && !last) return showActivity();
    kept_.reset();
    context_.view.showPicture(picture, origin, errors);
    if (last && quick_) context_.view.tell(tr("Refined. The next movement shows the live frame again."));
    showActivity();
}

void RenderOperations::onFailed(const QString& text) {
    quick_ ? context_.notice.explain(text, {})
           : context_.view.tell(tr("No progressive rendering: %1").arg(text));
}

void RenderOperations::showActivity() {
    QStringList words;
    const FrameView& view = context_.view;
    if (preview_.active()) words.append(progressText());
    if (!preview_.active() && !view.showsLive()) words.append(tr("refined"));
    if (!view.showsLive() && view.origin().paths && view.origin().samples > 0)
        words.append(samplesText(view.origin().samples));
    const QString error = view.showsLive() ? QString() : errorText(view.origin());
    if (!error.isEmpty()) words.append(error);
    context_.view.setActivity(words.join(QStringLiteral("  ·  ")));
}

QString RenderOperations::progressText() const {
    constexpr double kHundred = 100;
    if (preview_.progress() <= 0) return tr("rendering…");
    return tr("rendering %1 %").arg(QLocale().toString(kHundred * preview_.progress(), 'f', 0));
}

} // namespace gui
