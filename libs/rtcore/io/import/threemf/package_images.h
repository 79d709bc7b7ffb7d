/// The images inside a 3MF package, and those that lie on each other.
#pragma once

#include "rtcore/io/import/materials/texture_store.h"
#include "rtcore/io/import/threemf/model_part.h"
#include "rtcore/io/import/threemf/package.h"

#include <map>
#include <string>
#include <vector>

namespace rtcore::threemf {

/// A colour, or an image where there is a path.
struct ImageLayer {
    Paint paint;
    std::string path;
    bool multiplies = false; ///< with what is below it, else it covers that
};

class PackageImages : public EmbeddedPictures {
  public:
    /// Must not outlive `package`.
    explicit PackageImages(Package& package) : package_(package) {}

    /// The image of this name is that of layers, the lowest first.
    void compose(const std::string& name, std::vector<ImageLayer> layers) {
        composed_[name] = std::move(layers);
    }

    /// Any name: one that is not in the package is not looked for outside of it.
    bool has(const std::string& /*name*/) const override { return true; }
    LdrImage decode(const std::string& name) const override;

  private:
    LdrImage single(const std::string& path) const;
    Package& package_;
    std::map<std::string, std::vector<ImageLayer>> composed_;
};

} // namespace rtcore::threemf
