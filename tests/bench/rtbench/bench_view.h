/// Where scenes are looked at from.
#pragma once

#include "rtcore/io/scene_loader.h"
#include "rtcore/math/vec.h"
#include "rtcore/scene/camera.h"

#include <filesystem>
#include <string>
#include <vector>

namespace rtbench {

struct BenchView {
    std::string name; ///< tells several views of a scene apart; may be empty
    rtcore::Vec3 eye, at;
    rtcore::Vec3 up{0, 1, 0};
    float fov = 60; ///< vertical, degrees
    rtcore::Vec3 light;

    /// For images that are `aspect` times as wide as high.
    rtcore::Camera camera(float aspect) const;
};

/// The [[view]] tables of a file:
///   version = 1
///   [[view]]
///   scene = "sibenik.ply"      # stem of the model's file, with any extension or none
///   name = "nave"              # optional
///   eye = [-16.0, -10.0, 0.0]
///   at = [10.0, -9.0, 0.0]
///   up = [0.0, 1.0, 0.0]       # optional
///   fov = 60.0                 # vertical, degrees; optional
///   light = [-2.0, 4.0, 0.0]
class ViewFile {
  public:
    ViewFile() = default;
    /// Throws FileError.
    explicit ViewFile(const std::filesystem::path& path);

    /// Those of the model, in the order of the file.
    std::vector<BenchView> viewsOf(const std::filesystem::path& model) const;

  private:
    struct Entry {
        std::string stem;
        BenchView view;
    };
    std::vector<Entry> entries_;
};

/// From inside for interiors, of the whole for objects; a .scn's own camera and first light count.
BenchView makeView(const rtcore::LoadedScene& loaded);

} // namespace rtbench
