#include "rtcore/io/light/light_file.h"

#include "rtcore/io/bsp/bsp_checksum.h"
#include "rtcore/io/light/light_bytes.h"
#include "rtcore/platform/error.h"
#include "rtcore/platform/files.h"

#include <algorithm>
#include <array>
#include <vector>

namespace rtcore {

namespace {

[[noreturn]] void failLight(const std::string& name, const Sentence& problem) {
    throw FileError(FailureKind::BadData, name,
                    say("{0}; delete it, and its light is learned anew", problem));
}

/// Checks that a file of so many bytes, which begins with these, is as long as it says.
LightHead checkedHead(std::span<const std::byte> first, std::uint64_t size, const std::string& name) {
    const std::span<const std::byte> magic = std::as_bytes(std::span(kLightMagic));
    if (first.size() < magic.size() || !std::ranges::equal(first.first(magic.size()), magic))
        failLight(name, form("is no file of indirect light of this suite"));
    if (first.size() < kLightHeadBytes) failLight(name, form("the file is cut off"));
    const LightHead head = lightHeadOf(first);
    if (head.version != kLightVersion) failLight(name, form("the file is of another version of this suite"));
    if (head.records > IndirectState::kMaxRecords || head.cells > IndirectState::kMaxCells ||
        head.guesses > 1)
        failLight(name, form("its head makes no sense"));
    if (size < sizeOf(head)) failLight(name, form("the file is cut off"));
    if (size > sizeOf(head)) failLight(name, form("the file is longer than it should be"));
    return head;
}

} // namespace

std::uint64_t lightFileBytes(std::size_t records, std::size_t cells) {
    LightHead head;
    head.records = static_cast<std::uint32_t>(records);
    head.cells = static_cast<std::uint32_t>(cells);
    return sizeOf(head);
}

void writeLightFile(const std::filesystem::path& path, const LightKey& key, const IndirectState& light) {
    if (const auto problem = checkIndirectState(light))
        throw FileError(FailureKind::BadData, path.string(), say("not written: {0}", *problem));
    const std::vector<std::byte> bytes = lightBytes(key, light);
    const std::array pieces{std::span<const std::byte>(bytes)};
    writeFileAtomically(path, pieces);
}

LightFile readLightFile(const std::filesystem::path& path, const LightKey& key) {
    InputFile file(path);
    const std::span<const std::byte> first = file.head(kLightHeadBytes);
    if (file.size() > 0) checkedHead(first, file.size(), path.string());
    const FileBytes all = file.read();
    return readLightFile(all.bytes, key, path.string());
}

LightFile readLightFile(std::span<const std::byte> bytes, const LightKey& key, const std::string& name) {
    const LightHead head =
        checkedHead(bytes.first(std::min(bytes.size(), kLightHeadBytes)), bytes.size(), name);
    if (crc32Of(bytes.subspan(kLightCrcFrom)) != head.crc)
        failLight(name, form("the file is damaged (its checksum differs)"));
    LightFile file;
    if (head.surfaces != key.surfaces) return file;
    file.match = head.light == key.light ? LightMatch::Same : LightMatch::OtherLight;
    if (file.match != LightMatch::Same) return file;
    file.light = lightBehind(head, bytes.subspan(kLightHeadBytes), key.bounds);
    if (const auto problem = checkIndirectState(file.light)) failLight(name, *problem);
    return file;
}

Sentence lightIsUnused(const std::filesystem::path& path) {
    return say("{0}: it is not used: that takes indirect.mode=live, and by paths a net that denoises",
               path.string());
}

} // namespace rtcore
