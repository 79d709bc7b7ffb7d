#include "rtcore/io/import/assimp/assimp_files.h"

#include "rtcore/platform/paths.h"

#include <assimp/DefaultIOSystem.h>
#include <assimp/IOStream.hpp>

#include <utility>

namespace rtcore {

namespace {

class FilesForAssimp : public Assimp::DefaultIOSystem {
  public:
    explicit FilesForAssimp(std::shared_ptr<std::vector<std::string>> files) : files_(std::move(files)) {}

    Assimp::IOStream* Open(const char* file, const char* mode) override {
        std::unique_ptr<Assimp::IOStream> stream(DefaultIOSystem::Open(file, mode));
        if (!stream) return nullptr;
        files_->push_back(plainPath(file).string());
        return stream.release();
    }

  private:
    std::shared_ptr<std::vector<std::string>> files_;
};

} // namespace

Assimp::IOSystem* filesForAssimp(std::shared_ptr<std::vector<std::string>> files) {
    return new FilesForAssimp(std::move(files));
}

} // namespace rtcore
