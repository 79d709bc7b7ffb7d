#include "rtcore/io/import/gltf/buffers.h"

#include "rtcore/io/import/gltf/data_uri.h"
#include "rtcore/io/import/gltf/meshopt_view.h"
#include "rtcore/io/import/materials/texture_files.h"
#include "rtcore/platform/paths.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace rtcore::gltf {

Buffers::Buffers(const Container& container, const std::filesystem::path& model, ImportReport& report)
    : container_(container), folder_(model.parent_path()), report_(report) {}

Buffers::Buffer Buffers::openFile(const std::string& uri) {
    const auto path = findTextureFile(folder_, uri);
    if (!path) {
        missing_.push_back(percentDecoded(uri));
        return {};
    }
    Buffer buffer;
    buffer.kind = Kind::File;
    buffer.path = *path;
    buffer.size = InputFile(*path).size();
    addFile(report_, plainPath(*path).string());
    return buffer;
}

Buffers::Buffer Buffers::open(std::size_t number) {
    const Json& stated = element(member(container_.root, "buffers"), number);
    const std::string uri = text(stated, "uri");
    Buffer buffer;
    if (uri.empty()) {
        if (number != 0 || container_.binaryBytes == 0) return buffer;
        buffer.kind = Kind::Chunk;
        buffer.size = container_.binaryBytes;
    } else if (isDataUri(uri)) {
        buffer.kind = Kind::Bytes;
        buffer.bytes = bytesOfDataUri(uri);
        buffer.size = buffer.bytes.size();
    } else {
        buffer = openFile(uri);
    }
    return buffer;
}

Buffers::Buffer& Buffers::opened(std::size_t number) {
    const auto at = buffers_.find(number);
    return at != buffers_.end() ? at->second : buffers_.emplace(number, open(number)).first->second;
}

std::uint64_t Buffers::size(std::size_t buffer) { return opened(buffer).size; }

bool Buffers::read(std::size_t number, std::uint64_t offset, std::span<std::byte> room) {
    const Buffer& buffer = opened(number);
    if (offset > buffer.size || room.size() > buffer.size - offset) return false;
    if (room.empty()) return true;
    if (buffer.kind == Kind::Bytes) {
        std::memcpy(room.data(), buffer.bytes.data() + offset, room.size());
        return true;
    }
    if (buffer.kind == Kind::Chunk)
        return container_.file.readAt(container_.binary + offset, room) == room.size();
    if (!file_ || filePath_ != buffer.path) {
        file_.emplace(buffer.path);
        filePath_ = buffer.path;
    }
    return file_->readAt(offset, room) == room.size();
}

std::optional<ViewPlace> Views::place(const Json& view) {
    const auto buffer = index(view, "buffer");
    const auto bytes = wholeNumber(member(view, "byteLength"));
    if (!buffer || !bytes) return std::nullopt;
    const std::uint64_t offset = wholeNumber(view, "byteOffset", 0), size = buffers_.size(*buffer);
    if (offset > size) return std::nullopt;
    return ViewPlace{*buffer, offset, std::min(*bytes, size - offset)};
}

const std::vector<std::byte>* Views::decoded(std::size_t number) {
    const Json& view = element(member(root_, "bufferViews"), number);
    const Json& packed = extension(view, kMeshoptExtension);
    if (packed.is_null() || !readsMeshopt()) return nullptr;
    auto known = decoded_.find(number);
    if (known == decoded_.end()) {
        std::vector<std::byte> result;
        if (const auto at = place(packed)) {
            std::vector<std::byte> code(at->bytes);
            if (buffers_.read(at->buffer, at->offset, code))
                result = decodeMeshopt(code, meshoptView(packed));
        }
        known = decoded_.emplace(number, std::move(result)).first;
    }
    return known->second.empty() ? nullptr : &known->second; // then there may be a plain one beside it
}

std::uint64_t Views::size(std::size_t view) {
    if (const auto* const bytes = decoded(view)) return bytes->size();
    const auto at = place(element(member(root_, "bufferViews"), view));
    return at ? at->bytes : 0;
}

std::uint64_t Views::stride(std::size_t view) const {
    return wholeNumber(element(member(root_, "bufferViews"), view), "byteStride", 0);
}

bool Views::read(std::size_t view, std::uint64_t offset, std::span<std::byte> room) {
    if (const auto* const bytes = decoded(view)) {
        if (offset > bytes->size() || room.size() > bytes->size() - offset) return false;
        if (!room.empty()) std::memcpy(room.data(), bytes->data() + offset, room.size());
        return true;
    }
    const auto at = place(element(member(root_, "bufferViews"), view));
    if (!at || offset > at->bytes || room.size() > at->bytes - offset) return false;
    return buffers_.read(at->buffer, at->offset + offset, room);
}

std::vector<std::byte> Views::bytes(std::size_t view) {
    std::vector<std::byte> all(size(view));
    if (!read(view, 0, all)) all.clear();
    return all;
}

} // namespace rtcore::gltf
