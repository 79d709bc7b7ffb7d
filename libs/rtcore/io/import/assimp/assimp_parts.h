/// Interfaces between the sources that include Assimp.
#pragma once

#include "rtcore/io/import/assimp/format_quirks.h"
#include "rtcore/io/import/assimp/material_text.h"
#include "rtcore/io/import/import_report.h"
#include "rtcore/io/import/materials/material_mapping.h"
#include "rtcore/io/import/mesh/affine.h"
#include "rtcore/math/box.h"
#include "rtcore/scene/model.h"

#include <map>
#include <string>

struct aiMaterial;
struct aiScene;
template <typename Real>
class aiMatrix4x4t;

namespace rtcore {

/// Which of a mesh's texture coordinates a material uses, and what is done to them first: uv * scale +
/// offset.
struct TexcoordUse {
    unsigned int set = 0;
    Vec2 scale{1, 1}, offset;
    friend bool operator==(const TexcoordUse&, const TexcoordUse&) = default;
};

/// `text`: what stands in the file of this material.
SourceMaterial sourceMaterialOf(const aiMaterial& material, const FormatQuirks& quirks,
                                const MaterialText& text);
/// The coordinates of the first image, the diffuse one if there is one: one record has one set of coordinates
/// for all of its images.
TexcoordUse texcoordUseOf(const aiMaterial& material, ImportReport& report);

class SceneEmbeddedPictures : public EmbeddedPictures {
  public:
    explicit SceneEmbeddedPictures(const aiScene& scene) : scene_(scene) {}
    bool has(const std::string& name) const override;
    LdrImage decode(const std::string& name) const override;

  private:
    const aiScene& scene_;
};

Affine affineOf(const aiMatrix4x4t<float>& matrix);

/// World transforms of the nodes that joints, lights and cameras are named after.
using NodeTransforms = std::map<std::string, Affine>;
/// Under this name of no node: that of what stands below none, where an origin was taken off.
inline constexpr const char* kNoNode = "\n";

/// Appends the scene's lights and cameras. `bounds` of the model sets the scale of lights without units.
void addLights(const aiScene& scene, const NodeTransforms& transforms, const FormatQuirks& quirks,
               const Box3& bounds, ModelBuffers& model, ImportReport& report);
void addCameras(const aiScene& scene, const NodeTransforms& transforms, const FormatQuirks& quirks,
                ModelBuffers& model, ImportReport& report);

} // namespace rtcore
