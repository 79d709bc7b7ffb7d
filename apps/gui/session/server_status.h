/// The server's report on itself, as the window shows it.
#pragma once

#include <QSize>
#include <QVector3D>

#include <array>

namespace gui {

/// The camera of the server; scene units, degrees. Before the first frame it is not known.
struct View {
    std::array<double, 3> origin{}; ///< where the scene's zero lies in the coordinates of the model's file
    QVector3D eye, forward{0, 0, -1}, up{0, 1, 0};
    float fieldOfView = 0;   ///< of a view with perspective; else 0
    float parallelWidth = 0; ///< of one without: from the left edge of the image to the right one; else 0
    bool walking = false;
    bool known() const { return fieldOfView > 0 || parallelWidth > 0; }
    friend bool operator==(const View&, const View&) = default;
};

/// As commands take it.
inline std::array<float, 3> numbersOf(const QVector3D& v) { return {v.x(), v.y(), v.z()}; }
/// The same of a position in the scene: in the coordinates of the model's file.
inline std::array<double, 3> positionOf(const QVector3D& p, const View& view) {
    const auto& [x, y, z] = view.origin;
    return {double{p.x()} + x, double{p.y()} + y, double{p.z()} + z};
}

struct ServerStatus {
    double framesPerSecond = 0;
    double frameSeconds = 0;
    double raysPerSecond = 0;
    double kept = 0; ///< part of the last frame that was taken from those before it, 0..1
    double indirectError =
        0; ///< standard error of the last frame's indirect light, a part of it; 0: there is none
    quint64 polygons = 0;
    QSize resolution;   ///< pixels of a frame; empty while nothing is loaded
    float exposure = 0; ///< the constant of the tone mapping
    float progress = 1; ///< of loading; 1 = nothing is being loaded
    View view;
    bool idle = false;   ///< the next frame would equal the last
    bool paused = false; ///< no frame comes until the server is told to resume
    bool recording = false;
    quint64 stateRevision = 0; ///< grows when `state` would answer something else
    quint64 imageRevision = 0; ///< grows when the image of a view of this size is another
    quint64 messages = 0;      ///< number of messages so far; grows
    friend bool operator==(const ServerStatus&, const ServerStatus&) = default;
};

} // namespace gui
