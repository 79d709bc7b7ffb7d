/// Textures and images of a glTF file.
#pragma once

#include "rtcore/io/import/gltf/buffers.h"
#include "rtcore/io/import/materials/texture_store.h"

#include <cstddef>
#include <map>
#include <optional>
#include <string>

namespace rtcore::gltf {

/// The images that are inside of the file or its buffers, by the names that imageName() gives them.
class Images : public EmbeddedPictures {
  public:
    /// Both must outlive the object.
    Images(const Json& root, Views& views);

    bool has(const std::string& name) const override { return numbers_.contains(name); }
    LdrImage decode(const std::string& name) const override;

    /// The texture that `use` (a textureInfo) names, as a material uses it; none where there is no image of a
    /// format that is read.
    SourceMap mapOf(const Json& use) const;

  private:
    const Json& root_;
    Views& views_;
    std::map<std::string, std::size_t> numbers_; ///< of images inside
    std::map<std::size_t, std::string> names_;
};

/// Whether a texture has an image by this extension alone, and so none without it.
bool needsImagesOf(const Json& root, const std::string& extension);

} // namespace rtcore::gltf
