#include "rtcore/io/import/assimp/collada_text.h"

#include "rtcore/io/import/assimp/xml_text.h"
#include "rtcore/io/import/assimp/xml_tree.h"
#include "rtcore/platform/files.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>
#include <utility>

namespace rtcore {

namespace {

using View = std::string_view;

constexpr View kSpaces = " \t\r\n";
/// Assimp does not skip blanks at the beginning of these.
constexpr std::array<View, 3> kTrimmed{"color", "vcount", "v"};

/// Whether the head of such an element begins here, at its `<`.
bool isTrimmed(View text) {
    const View name = text.substr(1, std::min(text.find_first_of(" \t\r\n>", 1), text.size()) - 1);
    return std::ranges::find(kTrimmed, name) != kTrimmed.end();
}

/// Nothing where no blanks stand there.
std::optional<std::string> withoutLeadingBlanks(View text) {
    std::string trimmed;
    std::size_t from = 0;
    for (std::size_t at = text.find('<'); at != View::npos; at = text.find('<', at + 1)) {
        if (!isTrimmed(text.substr(at, 16))) continue;
        const std::size_t close = xml::endOfHead(text, at);
        if (close == View::npos) break;
        const std::size_t number = std::min(text.find_first_not_of(kSpaces, close + 1), text.size());
        if (number == close + 1) continue;
        trimmed += text.substr(from, close + 1 - from);
        from = number;
    }
    if (from == 0) return std::nullopt;
    trimmed += text.substr(from);
    return trimmed;
}

/// Nothing where each channel names a node and a transform of it. (Assimp looks for names of nodes in what
/// has no slash, counts from their end, and may end there, or move them.)
std::optional<std::string> withoutChannelsOfNoNode(View text) {
    constexpr View kNone = "none/none";
    std::string edited;
    View rest = text;
    std::size_t from = 0;
    while (const auto channel = xml::takeElement(rest, "channel")) {
        const View target = xml::valueOf(*channel, "target");
        if (target.data() == nullptr || target.find('/') != View::npos) continue;
        const auto begin = static_cast<std::size_t>(target.data() - text.data());
        edited += text.substr(from, begin - from);
        edited += kNone;
        from = begin + target.size();
    }
    if (from == 0) return std::nullopt;
    edited += text.substr(from);
    return edited;
}

} // namespace

std::optional<std::string> colladaForAssimp(const std::filesystem::path& path,
                                            const ColladaWeights& weights) {
    if (!xml::isCollada(path)) return std::nullopt;
    std::optional<std::string> text = colladaWithoutMorphs(path, weights);
    const FileBytes file = text ? FileBytes() : openFileBytes(path);
    const View own(reinterpret_cast<const char*>(file.bytes.data()), file.bytes.size());
    for (const auto edit : {withoutLeadingBlanks, withoutChannelsOfNoNode})
        if (auto edited = edit(text ? View(*text) : own)) text = std::move(edited);
    return text;
}

} // namespace rtcore
