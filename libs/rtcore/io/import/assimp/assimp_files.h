/// The files that Assimp opens beside the model's.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace Assimp {
class IOSystem;
}

namespace rtcore {

/// A file of which Assimp reads another text than what it holds.
struct ReplacedFile {
    std::string path; ///< absolute
    std::string text;
};

/// Which files there were.
struct OpenedFiles {
    std::vector<std::string> read;    ///< absolute
    std::vector<std::string> outside; ///< not read, since they are not in the model's folder or below
};

/// Adds to `files`. Outside of the model's folder, links resolved, nothing is read, but for buffers of glTF.
/// The caller deletes it, as Assimp::Importer does for its own.
Assimp::IOSystem* filesForAssimp(const std::filesystem::path& model, std::shared_ptr<OpenedFiles> files,
                                 std::optional<ReplacedFile> replaced);

} // namespace rtcore
