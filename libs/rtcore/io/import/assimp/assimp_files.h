/// The files that Assimp opens beside the model's.
#pragma once

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

/// Adds their absolute paths to `files`. The caller deletes it, as Assimp::Importer does for its own.
Assimp::IOSystem* filesForAssimp(std::shared_ptr<std::vector<std::string>> files,
                                 std::optional<ReplacedFile> replaced);

} // namespace rtcore
