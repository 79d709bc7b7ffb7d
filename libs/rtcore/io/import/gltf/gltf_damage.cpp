#include "rtcore/io/import/gltf/gltf_damage.h"

#include "rtcore/io/import/gltf/json_members.h"
#include "rtcore/platform/files.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <string_view>
#include <utility>

namespace rtcore {

namespace {

using gltf::Json;

constexpr std::size_t kGlbHead = 20; ///< magic, version, length; length and kind of the first chunk

std::string_view gltfText(const FileBytes& file) {
    return {reinterpret_cast<const char*>(file.bytes.data()), file.bytes.size()};
}

/// The JSON of a .glb is its first chunk.
std::string_view jsonOf(const std::filesystem::path& path, std::string_view text) {
    if (!text.starts_with("glTF")) return path.extension() == ".gltf" ? text : std::string_view();
    std::uint32_t version = 0, length = 0;
    if (text.size() < kGlbHead) return {};
    std::memcpy(&version, text.data() + 4, sizeof version);
    std::memcpy(&length, text.data() + 12, sizeof length);
    return version == 2 ? text.substr(kGlbHead, length) : std::string_view();
}

/// Damage to the head of a .glb. Files that are cut off are another matter (cut_off.h).
std::optional<Sentence> damageOfBinary(std::string_view text) {
    std::uint32_t version = 0;
    if (text.size() < kGlbHead) return {};
    std::memcpy(&version, text.data() + 4, sizeof version);
    if (version != 2)
        return say("it is glTF {0} in a binary file, which is not read; export it as glTF 2.0", version);
    if (text.substr(16, 4) != "JSON")
        return say("its first chunk holds no JSON; it is damaged: copy or export it again");
    std::uint32_t length = 0;
    std::memcpy(&length, text.data() + 12, sizeof length);
    if (length > text.size() - kGlbHead)
        return say("its first chunk is longer than the file; it is damaged: copy or export it again");
    return {};
}

} // namespace

std::optional<Sentence> gltfDamage(const std::filesystem::path& path) {
    const FileBytes file = openFileBytes(path);
    const std::string_view whole = gltfText(file);
    if (whole.starts_with("glTF"))
        if (auto damage = damageOfBinary(whole)) return damage;
    const std::string_view text = jsonOf(path, whole);
    if (text.empty()) return {};
    try {
        const Json root = Json::parse(text);
        const std::string version = gltf::text(gltf::member(root, "asset"), "version");
        if (version.empty()) return say("its JSON does not say which version of glTF it is; export it again");
        if (version[0] != '1' && version[0] != '2')
            return say("it is glTF {0}, which is not read; export it as glTF 2.0", version);
    } catch (const Json::parse_error& error) {
        if (error.byte > text.size() && text.size() == whole.size())
            return say("it is cut off: its JSON does not end within {0} bytes; copy it again", text.size());
        return say("its JSON is damaged at byte {0}; copy or export it again",
                   error.byte + static_cast<std::size_t>(text.data() - whole.data()));
    }
    return {};
}

} // namespace rtcore
