#include "rtcore/io/import/gltf/container.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace rtcore::gltf {

namespace {

constexpr std::uint64_t kHead = 12, kChunkHead = 8;

/// A name without an ending fits any content.
bool hasNameOfGltf(const std::filesystem::path& path) {
    constexpr std::array<std::string_view, 4> kEndings{".gltf", ".glb", ".vrm", ""};
    std::string ending = path.extension().string();
    std::ranges::transform(ending, ending.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return std::ranges::find(kEndings, ending) != kEndings.end();
}

struct Chunk {
    std::uint64_t begin = 0, bytes = 0;
    std::string kind; ///< four letters; "" where there is none
};

Chunk chunkAt(const InputFile& file, std::uint64_t at) {
    std::array<std::byte, kChunkHead> head{};
    if (file.readAt(at, head) < head.size()) return {};
    std::uint32_t bytes = 0;
    std::memcpy(&bytes, head.data(), sizeof bytes);
    const std::uint64_t begin = at + kChunkHead;
    return {begin, std::min<std::uint64_t>(bytes, file.size() - begin),
            std::string(reinterpret_cast<const char*>(head.data()) + 4, 4)};
}

/// Behind the first chunk; some writers count the bytes to the next multiple of 4 to it, some do not.
Chunk binaryChunk(const InputFile& file, const Chunk& json) {
    using namespace std::string_literals;
    const std::uint64_t end = json.begin + json.bytes, aligned = (end + 3) / 4 * 4;
    for (const std::uint64_t at : {end, aligned}) {
        const Chunk chunk = chunkAt(file, at);
        if (chunk.kind == "BIN\0"s) return chunk;
    }
    return {};
}

std::string textAt(const InputFile& file, std::uint64_t begin, std::uint64_t bytes) {
    std::string text(bytes, '\0');
    text.resize(file.readAt(begin, std::as_writable_bytes(std::span(text))));
    text.resize(text.find_last_not_of('\0') + 1); // which some writers pad with
    return text;
}

/// How many bytes the UTF-8 sequence at the beginning has; 0 where there is none.
std::size_t sequenceBytes(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const std::size_t bytes = byte(0) < 0x80   ? 1
                              : byte(0) < 0xC2 ? 0
                              : byte(0) < 0xE0 ? 2
                              : byte(0) < 0xF0 ? 3
                              : byte(0) < 0xF5 ? 4
                                               : 0;
    if (bytes > text.size()) return 0;
    for (std::size_t i = 1; i < bytes; ++i)
        if ((byte(i) & 0xC0U) != 0x80U) return 0;
    const bool tooLong = (byte(0) == 0xE0 && byte(1) < 0xA0) || (byte(0) == 0xF0 && byte(1) < 0x90);
    const bool surrogate = byte(0) == 0xED && byte(1) >= 0xA0, beyond = byte(0) == 0xF4 && byte(1) >= 0x90;
    return tooLong || surrogate || beyond ? 0 : bytes;
}

std::string asUtf8(std::string_view text) {
    std::string out;
    while (!text.empty()) {
        const std::size_t bytes = sequenceBytes(text);
        if (bytes == 0) {
            const auto code = static_cast<unsigned char>(text[0]);
            out += static_cast<char>(0xC0U | (code >> 6U));
            out += static_cast<char>(0x80U | (code & 0x3FU));
        } else {
            out += text.substr(0, bytes);
        }
        text.remove_prefix(std::max<std::size_t>(bytes, 1));
    }
    return out;
}

Json parsed(const std::string& text) {
    Json root = Json::parse(text, nullptr, false);
    if (root.is_discarded()) root = Json::parse(asUtf8(text), nullptr, false);
    return root;
}

} // namespace

std::optional<Container> openContainer(const std::filesystem::path& path) {
    std::error_code error;
    if (!hasNameOfGltf(path) || !std::filesystem::is_regular_file(path, error)) return std::nullopt;
    Container container{InputFile(path), {}, 0, 0};
    const InputFile& file = container.file;
    std::array<std::byte, kHead> head{};
    const bool binary =
        file.readAt(0, head) == head.size() && std::memcmp(head.data(), "glTF\2\0\0\0", 8) == 0;
    std::string text;
    if (binary) {
        const Chunk json = chunkAt(file, kHead);
        if (json.kind != "JSON") return std::nullopt;
        text = textAt(file, json.begin, json.bytes);
        const Chunk chunk = binaryChunk(file, json);
        container.binary = chunk.begin;
        container.binaryBytes = chunk.bytes;
    } else if (path.has_extension()) {
        text = textAt(file, 0, file.size());
    }
    container.root = parsed(text);
    if (!gltf::text(member(container.root, "asset"), "version").starts_with('2')) return std::nullopt;
    return container;
}

} // namespace rtcore::gltf
