#include "rtcore/io/import/assimp/assimp_files.h"

#include "rtcore/io/import/mesh/utf16_text.h"
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
        if (Assimp::IOStream* const text = asUtf8(*stream)) return text;
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
