/// The status of a server. Plain numbers: the library attaches no meaning to them.
#pragma once

#include <cstdint>
#include <type_traits>

namespace ipc {

struct Status {
    double frameSeconds = 0;    ///< what the last frame took
    double framesPerSecond = 0; ///< over the last second or so
    double raysPerSecond = 0;
    std::uint64_t polygons = 0; ///< of the scene
    std::uint32_t width = 0;    ///< pixels of a frame
    std::uint32_t height = 0;
    float eye[3] = {0, 0, 0};      ///< camera position, scene units
    float forward[3] = {0, 0, -1}; ///< unit vector
    float up[3] = {0, 1, 0};       ///< unit vector
    float fieldOfView = 0;         ///< horizontal, degrees; 0 of an orthographic view
    float exposure = 0;            ///< the constant of the tone mapping
    float progress = 0;            ///< of work that takes long, 0..1; 1 = nothing under way
    std::uint32_t mode = 0;        ///< a number of the server's own, such as flying or walking
    std::uint32_t idle = 0;        ///< 1: the next frame would equal the last
    std::uint32_t paused = 0;      ///< 1: no frame comes until the server is told to resume
    std::uint32_t recording = 0;   ///< 1: frames are being recorded
    std::uint32_t messages = 0;    ///< number of messages so far; grows
    float kept = 0;                ///< part of the last frame that was taken from those before it, 0..1
    float lightError = 0; ///< standard error of light that the last frame shows, a part of it; 0: not known
    float parallelWidth = 0; ///< of an orthographic view: scene units from its left edge to its right; else 0
    double wholeSeconds = 0; ///< what a frame of all pixels and samples takes, so far where it is under way
    double origin[3] = {0, 0, 0};    ///< what to add to the camera's position for that in the model's file
    std::uint64_t stateRevision = 0; ///< grows when what a client could ask for is another; 0: nothing yet
    std::uint64_t imageRevision = 0; ///< grows when the image of a view of this size is another
    friend bool operator==(const Status&, const Status&) = default;
};
static_assert(std::is_trivially_copyable_v<Status> && sizeof(Status) == 168 && alignof(Status) == 8);

} // namespace ipc
