/// A Renderer that makes images of a resting view by paths: RendererProcess in the bridge, something else in
/// tests.
#pragma once

#include <cstdint>
#include <string>

namespace bridge {

/// One thread; nothing waits.
class PathRenderer {
  public:
    virtual ~PathRenderer() = default;

    /// Where its images are seen.
    virtual const std::string& instance() const = 0;
    /// Path of a file of that name for a request, the same each time, in a folder of this user alone. Throws
    /// rtcore::FileError.
    virtual std::string file(const std::string& name) = 0;
    /// Begins that image, in place of one under way. Throws rtcore::FileError.
    virtual void render(std::uint64_t run, const std::string& scene, const std::string& camera) = 0;
    /// The image under way is not wanted any more.
    virtual void giveUp() = 0;
    /// To be called now and then; `wanted`: an image is under way. The exit code of a Renderer that has
    /// failed by itself, once; else 0. Throws rtcore::FileError where the next one cannot be started.
    virtual int tick(bool wanted) = 0;
};

} // namespace bridge
