#include "gui/operations/render_operations.h"

#include "gui/operations/actions.h"
#include "gui/view/frame_view.h"
#include "gui/view/input_capture.h"
#include "gui/view/notice_bar.h"

namespace gui {

RenderOperations::RenderOperations(const Desk& desk, QObject* parent)
    : QObject(parent), desk_(desk), still_(desk.session) {
    desk_.actions.on(ActionId::QuickRender,
                     [this] { quickRender(desk_.preferences.get(pref::stillAntialiasing)); });
    desk_.actions.bind(ActionId::ProgressiveRendering, pref::progressiveRendering);
    InputCapture& input = desk_.view.input();
    connect(&input, &InputCapture::commandKey, this, [this](int code, bool withL) {
        if (code == 'R' && desk_.session.live())
            quickRender(withL ? desk_.preferences.get(pref::stillAntialiasing) : 1);
    });
    connect(&input, &InputCapture::keyPressed, this, &RenderOperations::interrupt);
    connect(&input, &InputCapture::turned, this, &RenderOperations::interrupt);
    connect(&desk_.session, &Session::stateChanged, this, &RenderOperations::interrupt);
    connect(&desk_.session, &Session::statusChanged, this, [this] {
        if (desk_.session.status().view != shown_) interrupt();
    });
    connect(&still_, &StillProcess::rendered, this, [this](const QImage& picture) {
        desk_.view.showPicture(picture);
        desk_.view.tell(tr("Rendered. The next movement shows the live picture again."));
    });
    connect(&still_, &StillProcess::failed, this,
            [this](const QString& text) { desk_.notice.explain(text, {}); });
    connect(&still_, &StillProcess::activeChanged, this,
            [this] { desk_.view.setActivity(still_.active() ? tr("rendering…") : QString()); });
}

void RenderOperations::quickRender(int antialiasing) {
    shown_ = desk_.session.status().view;
    desk_.view.showLive();
    still_.render(antialiasing, desk_.preferences.get(pref::stillBloom));
}

void RenderOperations::interrupt() {
    if (still_.active()) still_.cancel();
    desk_.view.showLive();
}

} // namespace gui
