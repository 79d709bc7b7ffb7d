/// Where an environment comes from, as scenes name it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace rtcore {

enum class EnvironmentKind {
    Equirectangular, ///< one file
    Cross,           ///< one file, six faces unfolded
    Strip,           ///< one file, six faces in a row
    Faces,           ///< six files: +X -X +Y -Y +Z -Z
    Parts,           ///< no file: parts of the model that surround the rest (look/shell_picture.h)
};

/// One [[environment]] of a .scn.
struct EnvironmentFile {
    EnvironmentKind kind = EnvironmentKind::Equirectangular;
    std::vector<std::filesystem::path> files; ///< six for Faces, none for Parts, else one
    std::vector<std::string> parts;           ///< of Parts: names of the model's, as shell patterns
    std::string name;                         ///< may be ""
    float intensity = 1;                      ///< factor, >= 0
    float rotation = 0;                       ///< degrees, as Environment::turn(), -360..360
    friend bool operator==(const EnvironmentFile&, const EnvironmentFile&) = default;
};

} // namespace rtcore
