#include "rtcore/io/import/assimp/assimp_files.h"

#include "rtcore/platform/paths.h"

#include <assimp/DefaultIOSystem.h>
#include <assimp/IOStream.hpp>
#include <assimp/MemoryIOWrapper.h>

#include <cstdint>
#include <utility>

namespace rtcore {

namespace {

class FilesForAssimp : public Assimp::DefaultIOSystem {
  public:
    FilesForAssimp(std::shared_ptr<std::vector<std::string>> files, std::optional<ReplacedFile> replaced)
        : files_(std::move(files)), replaced_(std::move(replaced)) {}

    Assimp::IOStream* Open(const char* file, const char* mode) override {
        std::unique_ptr<Assimp::IOStream> stream(DefaultIOSystem::Open(file, mode));
        if (!stream) return nullptr;
        files_->push_back(plainPath(file).string());
        if (replaced_ && files_->back() == replaced_->path)
            return new Assimp::MemoryIOStream(reinterpret_cast<const std::uint8_t*>(replaced_->text.data()),
                                              replaced_->text.size());
        return stream.release();
    }

  private:
    std::shared_ptr<std::vector<std::string>> files_;
    std::optional<ReplacedFile> replaced_;
};

} // namespace

Assimp::IOSystem* filesForAssimp(std::shared_ptr<std::vector<std::string>> files,
                                 std::optional<ReplacedFile> replaced) {
    return new FilesForAssimp(std::move(files), std::move(replaced));
}

} // namespace rtcore
