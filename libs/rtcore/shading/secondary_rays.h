/// The rays that follow from those of a wave: mirrored, refracted, on through thin walls and holes.
#pragma once

#include "rtcore/shading/frame_context.h"
#include "rtcore/shading/paths/path_queue.h"
#include "rtcore/shading/surface/surface_split.h"
#include "rtcore/shading/wave.h"

#include <optional>
#include <vector>

namespace rtcore {

/// The ray that goes on as if a hole were all of the surface: an alpha texture lets it pass. Nothing where it
/// has passed too many; `path` is the ray's.
std::optional<Ray> rayThroughHole(const Surface& surface, Vec3 direction, Path& path);
/// Updates the media of a path that passes the surface where there is a hole, or nothing to be seen of it
/// (setMedia()).
void passUnbent(const Scene& scene, const Surface& surface, bool visible, Path& path);
/// The ray that goes on behind a surface that lets light through, straight on or refracted, and `path` as it
/// is there. Nothing where it is reflected as a whole, or has been bent `maxDepth` times or has passed too
/// many surfaces.
std::optional<Ray> rayBehind(const Surface& surface, int maxDepth, Path& path);

/// They wait in queues, so that rays of one kind are traced together. One for each thread; keeps its memory.
class SecondaryRays {
  public:
    /// Starts with the rays of a wave of primary rays.
    void start();
    bool empty() const { return mirrored_.empty() && refracted_.empty(); }
    /// Takes rays of one kind, which become the wave's; some wait.
    void takeNext(Wave& wave);

    /// Sends on what passes through a hole of an alpha texture; `path` is the ray's, its weight what passes.
    void addHole(const FrameContext& frame, const Surface& surface, Vec3 direction, Path path);
    /// Takes a point of the wave that lets light through; its ray follows with
    /// makeSecondaryRays().
    void addTransparent(const Surface& surface, Colour transmitted, const Path& path);
    /// Adds the mirrored and the refracted rays of the wave.
    void makeSecondaryRays(const FrameContext& frame, const Wave& wave);

    /// The queues change places as they are emptied: makes room in each for the rays of the fullest, so that
    /// steady frames do not allocate.
    void evenMemory();

  private:
    struct Transparent {
        Surface surface;
        Path path; ///< its weight is that of the transmitted ray
    };
    void refract(const FrameContext& frame, const Transparent& point);

    PathQueue current_; ///< the rays of the wave
    PathQueue mirrored_, refracted_;
    std::vector<Transparent> transparent_; ///< of the wave
};

} // namespace rtcore
