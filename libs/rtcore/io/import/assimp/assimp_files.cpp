#include "rtcore/io/import/assimp/assimp_files.h"

#include "rtcore/io/import/materials/model_folder.h"
#include "rtcore/io/import/mesh/utf16_text.h"
#include "rtcore/io/import/text/statement_text.h"
#include "rtcore/platform/paths.h"

#include <assimp/DefaultIOSystem.h>
#include <assimp/IOStream.hpp>
#include <assimp/MemoryIOWrapper.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

namespace rtcore {

namespace {

/// All of a file of text in UTF-16, as UTF-8; null for others, which are as they were before.
Assimp::IOStream* asUtf8(Assimp::IOStream& file) {
    std::array<std::byte, 2> mark{};
    const bool isUtf16 = file.Read(mark.data(), 1, mark.size()) == mark.size() && beginsAsUtf16(mark);
    file.Seek(0, aiOrigin_SET);
    if (!isUtf16) return nullptr;
    std::vector<std::byte> bytes(file.FileSize());
    bytes.resize(file.Read(bytes.data(), 1, bytes.size()));
    file.Seek(0, aiOrigin_SET);
    const auto text = utf8OfUtf16(bytes);
    if (!text) return nullptr;
    auto* const own = new std::uint8_t[text->size()]; // which the stream deletes
    std::ranges::copy(*text, own);
    return new Assimp::MemoryIOStream(own, text->size(), true);
}

bool isGltf(const std::filesystem::path& model) {
    const std::string extension = inSmallLetters(model.extension().string());
    return extension == ".gltf" || extension == ".glb";
}

class FilesForAssimp : public Assimp::DefaultIOSystem {
  public:
    FilesForAssimp(const std::filesystem::path& model, std::shared_ptr<OpenedFiles> files,
                   std::optional<ReplacedFile> replaced)
        : home_(model), namesBuffers_(isGltf(model)), files_(std::move(files)),
          replaced_(std::move(replaced)) {}

    Assimp::IOStream* Open(const char* file, const char* mode) override {
        if (!namesBuffers_ && Exists(file) && !home_.holds(file)) {
            if (std::ranges::find(files_->outside, file) == files_->outside.end())
                files_->outside.emplace_back(file);
            return nullptr;
        }
        std::unique_ptr<Assimp::IOStream> stream(DefaultIOSystem::Open(file, mode));
        if (!stream) return nullptr;
        files_->read.push_back(plainPath(file).string());
        if (replaced_ && files_->read.back() == replaced_->path)
            return new Assimp::MemoryIOStream(reinterpret_cast<const std::uint8_t*>(replaced_->text.data()),
                                              replaced_->text.size());
        if (Assimp::IOStream* const text = asUtf8(*stream)) return text;
        return stream.release();
    }

  private:
    ModelFolder home_;
    bool namesBuffers_;
    std::shared_ptr<OpenedFiles> files_;
    std::optional<ReplacedFile> replaced_;
};

} // namespace

Assimp::IOSystem* filesForAssimp(const std::filesystem::path& model, std::shared_ptr<OpenedFiles> files,
                                 std::optional<ReplacedFile> replaced) {
    return new FilesForAssimp(model, std::move(files), std::move(replaced));
}

} // namespace rtcore
