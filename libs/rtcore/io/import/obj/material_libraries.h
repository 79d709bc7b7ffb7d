/// Where the material libraries of an OBJ file are.
#pragma once

#include "rtcore/io/import/materials/model_folder.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rtcore {

struct MaterialLibrary {
    std::filesystem::path path;
    std::string folder; ///< as seen from the model's, with "/" at its end; "" where it is that
};

class LibraryFinder {
  public:
    explicit LibraryFinder(const std::filesystem::path& model);

    /// The libraries behind `mtllib`: one name, which may hold blanks, or several, each of which may stand in
    /// quotes. A name is looked for as it stands, by its shorterPaths() and whatever the case of its letters,
    /// in the model's folder and below. Outside of that, and of the folder to which a link to the model's
    /// file leads, nothing is read, links resolved. A model whose libraries are all missing gets the one that
    /// is called as it is, if there is such a one.
    std::vector<MaterialLibrary> find(std::string_view names);

    const std::vector<std::string>& missing() const { return missing_; }
    /// Names of those that lie outside of the model's folder.
    const std::vector<std::string>& outside() const { return outside_; }

  private:
    std::optional<MaterialLibrary> findOne(std::string_view name, bool& isOutside) const;
    struct Search {
        std::vector<MaterialLibrary> found;
        std::vector<std::string> missing, outside;
    };
    void findSeveral(std::string_view names, Search& to) const;

    std::filesystem::path folder_; ///< of the model
    ModelFolder home_;
    std::filesystem::path namesake_; ///< the name of the library that is called like the model
    std::vector<std::string> missing_, outside_;
};

} // namespace rtcore
