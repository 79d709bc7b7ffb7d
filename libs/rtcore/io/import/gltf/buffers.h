/// The bytes behind a glTF file's JSON: buffers, and views of them, where it says that they are.
#pragma once

#include "rtcore/io/import/gltf/container.h"
#include "rtcore/io/import/import_report.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace rtcore::gltf {

/// Buffers are opened when they are first asked for: the chunk of a .glb, bytes in a URI, or a file that is
/// looked for as images are (texture_files.h) and added to the report. Bytes are copied out of files, so that
/// one that shrinks meanwhile does no harm.
class Buffers {
  public:
    /// All must outlive the object.
    Buffers(const Container& container, const std::filesystem::path& model, ImportReport& report);

    /// 0 for one that is not there.
    std::uint64_t size(std::size_t buffer);
    /// False where not all of `room` is there.
    bool read(std::size_t buffer, std::uint64_t offset, std::span<std::byte> room);
    /// Names of files that were asked for and are not there, as a person writes them.
    const std::vector<std::string>& missing() const { return missing_; }

  private:
    enum class Kind { None, Chunk, Bytes, File };
    struct Buffer {
        Kind kind = Kind::None;
        std::uint64_t size = 0;
        std::vector<std::byte> bytes;
        std::filesystem::path path;
    };
    Buffer& opened(std::size_t buffer);
    Buffer open(std::size_t buffer);
    Buffer openFile(const std::string& uri);

    const Container& container_;
    std::filesystem::path folder_;
    ImportReport& report_;
    std::map<std::size_t, Buffer> buffers_;
    std::optional<InputFile> file_; ///< the one that was read last
    std::filesystem::path filePath_;
    std::vector<std::string> missing_;
};

/// Where a view's bytes are before anything is done to them.
struct ViewPlace {
    std::size_t buffer = 0;
    std::uint64_t offset = 0, bytes = 0; ///< all of which are there
};

class Views {
  public:
    Views(const Json& root, Buffers& buffers) : root_(root), buffers_(buffers) {}

    /// 0 for one that is not there, or cannot be decoded.
    std::uint64_t size(std::size_t view);
    /// Bytes between two elements; 0: they follow each other.
    std::uint64_t stride(std::size_t view) const;
    /// False where not all of `room` is there.
    bool read(std::size_t view, std::uint64_t offset, std::span<std::byte> room);
    /// All of it; empty where it is not there.
    std::vector<std::byte> bytes(std::size_t view);

  private:
    std::optional<ViewPlace> place(const Json& view);
    const std::vector<std::byte>* decoded(std::size_t view);

    const Json& root_;
    Buffers& buffers_;
    std::map<std::size_t, std::vector<std::byte>> decoded_; ///< those that are compressed
};

} // namespace rtcore::gltf
