#include "rtcore/io/import/assimp/assimp_files.h"

#include "rtcore/io/import/assimp/material_text.h"
#include "rtcore/platform/paths.h"

#include <assimp/DefaultIOSystem.h>
#include <assimp/MemoryIOWrapper.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <utility>

namespace rtcore {

namespace {

bool isMaterialLibrary(const std::filesystem::path& path) {
    const std::string ending = path.extension().string();
    return ending == ".mtl" || ending == ".MTL" || ending == ".Mtl";
}

class FilesForAssimp : public Assimp::DefaultIOSystem {
  public:
    explicit FilesForAssimp(std::shared_ptr<std::vector<std::string>> files) : files_(std::move(files)) {}

    Assimp::IOStream* Open(const char* file, const char* mode) override {
        std::unique_ptr<Assimp::IOStream> stream(DefaultIOSystem::Open(file, mode));
        if (!stream) return nullptr;
        files_->push_back(plainPath(file).string());
        return isMaterialLibrary(file) ? plainLibrary(*stream) : stream.release();
    }

  private:
    static Assimp::IOStream* plainLibrary(Assimp::IOStream& stream) {
        std::string text(stream.FileSize(), '\0');
        text.resize(text.empty() ? 0 : stream.Read(text.data(), 1, text.size()));
        text = withoutMapOptions(text);
        auto* const bytes = new std::uint8_t[text.size() + 1]; // which the stream deletes
        std::copy(text.begin(), text.end(), bytes);
        return new Assimp::MemoryIOStream(bytes, text.size(), true);
    }

    std::shared_ptr<std::vector<std::string>> files_;
};

} // namespace

Assimp::IOSystem* filesForAssimp(std::shared_ptr<std::vector<std::string>> files) {
    return new FilesForAssimp(std::move(files));
}

} // namespace rtcore
