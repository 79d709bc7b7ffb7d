/// The elements of FBX files, binary and text, that tell what Assimp passes over.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace rtcore {

using FbxValue = std::variant<std::int64_t, double, std::string>;

struct FbxElement {
    std::string name;
    std::vector<FbxValue> values; ///< the first 16; of lists of numbers as many
    std::vector<FbxElement> children;

    /// Null where there is none.
    const FbxElement* child(std::string_view childName) const;
    /// 0 where it is none.
    double number(std::size_t index) const;
    std::int64_t id(std::size_t index) const;
    /// "" where it is none.
    std::string text(std::size_t index) const;
};

/// Whether a file is FBX by its name or its beginning.
bool isFbx(const std::filesystem::path& path);

/// The property that names the program from which a scene comes.
inline constexpr std::string_view kFbxApplication = "Original|ApplicationName";

/// `FBXHeaderExtension` as far as it names that, `Objects` and `Connections`, and of those the models,
/// deformers, attributes, materials and geometries with some of their properties; geometries without their
/// lists. Of a damaged file what stands before the damage. Throws as openFileBytes() does.
std::vector<FbxElement> readFbxElements(const std::filesystem::path& path);

} // namespace rtcore
