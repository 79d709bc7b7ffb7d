/// Photometric profiles of a glTF file (EXT_lights_ies).
#pragma once

#include "rtcore/io/import/gltf/buffers.h"
#include "rtcore/io/import/import_report.h"
#include "rtcore/io/import/materials/model_folder.h"
#include "rtcore/scene/photometry.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace rtcore::gltf {

/// A profile as lights have it.
struct Luminaire {
    std::uint32_t photometry = 0;
    float intensity = 0; ///< where it is brightest, W/sr, of 683 lm to a watt
};

/// Profiles are read when they are first asked for: of a view, of bytes in a URI, or of a file in the model's
/// folder or below, links resolved, which is added to the report. One that cannot be read costs itself alone,
/// with a warning.
class Luminaires {
  public:
    /// All must outlive the object.
    Luminaires(const Json& root, Views& views, const std::filesystem::path& model, ImportReport& report);

    /// Of that number in the file, as it is or as a mirror shows it; nothing where it cannot be read.
    std::optional<Luminaire> find(std::size_t number, bool mirrored);

  private:
    PhotometricWeb read(const Json& stated, const std::string& name);
    std::string textOf(const Json& stated);
    std::string textOfFile(const std::string& uri);
    Luminaire keep(const PhotometricWeb& web);

    const Json& root_;
    Views& views_;
    std::filesystem::path folder_;
    ModelFolder home_;
    ImportReport& report_;
    std::map<std::pair<std::size_t, bool>, std::optional<Luminaire>> found_;
    std::size_t numbers_ = 0; ///< of all that are kept
};

} // namespace rtcore::gltf
