/// Properties of materials that the text of model files states and Assimp does not hand over.
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

namespace rtcore {

/// Where the specular colour of a material comes from.
enum class SpecularOrigin {
    Stated,  ///< what Assimp has is right
    Texture, ///< the file has an image alone
    None,    ///< the file has none, so it is black
};

struct MaterialText {
    SpecularOrigin specular = SpecularOrigin::Stated;
};

class MaterialTexts {
  public:
    /// Reads a Collada file (.dae); empty for others.
    explicit MaterialTexts(const std::filesystem::path& path);

    /// `index` counts the materials as Assimp hands them over, `count` of them.
    MaterialText of(std::size_t index, std::size_t count) const;

  private:
    std::vector<MaterialText> inOrder_;
};

} // namespace rtcore
