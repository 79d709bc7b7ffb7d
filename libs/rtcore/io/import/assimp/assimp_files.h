/// The files that Assimp opens beside the model's.
#pragma once

#include <memory>
#include <string>
#include <vector>

namespace Assimp {
class IOSystem;
}

namespace rtcore {

/// Adds their absolute paths to `files`. The caller deletes it, as Assimp::Importer does for its own.
Assimp::IOSystem* filesForAssimp(std::shared_ptr<std::vector<std::string>> files);

} // namespace rtcore
