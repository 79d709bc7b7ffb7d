#include "gui/view/shown_image.h"

#include "gui/session/session.h"
#include "gui/view/frame_view.h"

namespace gui {

namespace {

// An image that was rendered before the window had its size may have another shape than the server's.
double widthIn(const SceneState& state, const ServerStatus& status, const QSizeF& image) {
    const double own = parallelWidth(state, status.resolution), here = parallelWidth(state, image);
    return double{status.view.parallelWidth} * (own > 0 && here > 0 ? here / own : 1);
}

} // namespace

std::optional<SceneImage> shownImage(const FrameView& view, const Session& session, const SceneState& state) {
    const View& camera = session.status().view;
    const QRectF area = view.pictureArea();
    const QSizeF size = view.shown().size();
    if (!session.live() || area.isEmpty() || size.isEmpty() || !camera.known()) return std::nullopt;
    return SceneImage(camera, widthIn(state, session.status(), size), area, size.width() / size.height());
}

// An image that was rendered before the window had its size may have another shape than the server's.
std::optional<QPointF> inServersImage(const FrameView& view, const Session& session, const QPointF& at) {
    const auto there = view.inPicture(at);
    const QSizeF own = session.status().resolution, shown = view.shown().size();
    if (!there || own.isEmpty() || shown.isEmpty()) return std::nullopt;
    const double taller = own.width() / own.height() * shown.height() / shown.width();
    const QPointF place((1 + there->x()) / 2, (1 - there->y() * taller) / 2);
    return QRectF(0, 0, 1, 1).contains(place) ? std::optional(place) : std::nullopt;
}

double cutSlack(const SceneState& state) {
    constexpr double kOfDiagonal = 1e-4;
    return state.bounds.empty() ? 0 : kOfDiagonal * double{state.bounds.diagonal()};
}

} // namespace gui
