/// The images of a model's materials, each read and kept once.
#pragma once

#include "rtcore/io/import/import_report.h"
#include "rtcore/scene/image_summary.h"
#include "rtcore/scene/model.h"

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rtcore {

/// An image as a material uses it.
struct SourceMap {
    std::string name; ///< as it stands in the file; "" = none
    TextureWrap wrapU = TextureWrap::Repeat, wrapV = TextureWrap::Repeat;
    TextureFilter filter = TextureFilter::Linear;
    std::uint32_t texcoordSet = 0; ///< of the mesh's, by which it lies

    bool empty() const { return name.empty(); }
};

/// A normal map, and the factor on how far it leans (Material::normalScale).
struct Relief {
    std::uint32_t texture = kNoTexture;
    float scale = 1;
};

/// The images inside a model's file.
class EmbeddedPictures {
  public:
    EmbeddedPictures() = default;
    virtual ~EmbeddedPictures() = default;
    EmbeddedPictures(const EmbeddedPictures&) = delete;
    EmbeddedPictures& operator=(const EmbeddedPictures&) = delete;
    virtual bool has(const std::string& name) const = 0;
    /// `name` is one that it has. Throws FileError BadData.
    virtual LdrImage decode(const std::string& name) const = 0;
};

/// Of formats that hold none.
class NoEmbeddedPictures : public EmbeddedPictures {
  public:
    bool has(const std::string& /*name*/) const override { return false; }
    LdrImage decode(const std::string& /*name*/) const override { return {}; }
};

class TextureStore {
  public:
    /// `model` gets textures and texels; `report` a warning for each image that is broken. `alive` is
    /// called before each image is read, and before it is stored.
    TextureStore(ModelBuffers& model, ImportReport& report, std::filesystem::path folder,
                 const EmbeddedPictures& embedded, std::function<void()> alive);

    /// The number of the texture, or kNoTexture when there is no such image. One image that wraps, lies or is
    /// filtered in several ways is several textures, whose texels are stored once.
    std::uint32_t texture(const SourceMap& map);
    /// The normals of the relief (relief.h) of an image of heights, which are multiplied by `scale`. An image
    /// that holds normals already, as many programs write them in its place, is taken as it stands and leans
    /// as far as `scale` says.
    Relief relief(const SourceMap& map, float scale);
    /// A summary of the image; nothing when it cannot be had. Does not add a texture.
    std::optional<ImageSummary> summary(const SourceMap& map);
    /// Names of images that were asked for and are not there.
    const std::vector<std::string>& missing() const { return missing_; }

  private:
    struct Picture {
        Texture stored;                      ///< where its texels are; of no width before
        std::vector<std::uint32_t> textures; ///< numbers: one for each way in which it is used
        std::optional<ImageSummary> summary;
        bool unreadable = false;
    };
    Picture& lookUp(const std::string& name, bool keep);
    bool load(const std::string& name, const std::string& key, Picture& picture);
    const std::string& keyOf(const std::string& name);
    std::optional<LdrImage> read(const std::string& name, const std::string& key);
    Texture stored(const LdrImage& image);
    std::uint32_t used(Picture& picture, const SourceMap& map);

    ModelBuffers& model_;
    ImportReport& report_;
    std::filesystem::path folder_;
    const EmbeddedPictures& embedded_;
    std::function<void()> alive_;
    std::map<std::string, std::string>
        keys_; ///< by name: the path that it means, "<name" inside the file, or ""
    std::map<std::string, Picture> pictures_; ///< by key
    struct KnownRelief {
        Picture picture; ///< of normals; without texels where `isNormals`
        float scale = 1; ///< Relief::scale
        bool isNormals = false;
    };
    std::map<std::string, KnownRelief> reliefs_; ///< by key, how it wraps, and the scale
    LdrImage last_; ///< the image read last: often asked for its summary first, then kept
    std::string lastKey_;
    std::vector<std::string> missing_;
};

} // namespace rtcore
