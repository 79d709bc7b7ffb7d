#include "rtcore/io/import/assimp/unread_content.h"

#include "rtcore/io/import/assimp/x3d_text.h"
#include "rtcore/io/import/assimp/xml_text.h"
#include "rtcore/io/import/assimp/xml_tree.h"
#include "rtcore/io/import/import_forms.h"
#include "rtcore/io/import/import_report.h"
#include "rtcore/platform/files.h"
#include "rtcore/platform/sentence.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

namespace rtcore {

namespace {

/// Nodes that show something, and that Assimp passes over.
constexpr std::array<std::string_view, 16> kX3dSurfaces{"Text",
                                                        "ProtoInstance",
                                                        "QuadSet",
                                                        "IndexedQuadSet",
                                                        "NurbsPatchSurface",
                                                        "NurbsSweptSurface",
                                                        "NurbsSwungSurface",
                                                        "NurbsTrimmedSurface",
                                                        "GeoElevationGrid",
                                                        "GeoTransform",
                                                        "CADAssembly",
                                                        "CADLayer",
                                                        "CADPart",
                                                        "CADFace",
                                                        "HAnimHumanoid",
                                                        "ParticleSystem"};

std::string_view textOf(const FileBytes& file) {
    return {reinterpret_cast<const char*>(file.bytes.data()), file.bytes.size()};
}

} // namespace

std::vector<const char*> unreadInCollada(const std::filesystem::path& path) {
    if (!xml::isCollada(path)) return {};
    const FileBytes file = openFileBytes(path);
    const std::string_view text = textOf(file);
    const auto has = [&](std::string_view word) { return text.find(word) != std::string_view::npos; };
    std::vector<const char*> sentences;
    const bool ends =
        has("<wrap_s>CLAMP") || has("<wrap_t>CLAMP") || has("<wrap_s>MIRROR") || has("<wrap_t>MIRROR");
    if (ends) sentences.push_back(import_forms::kWrapped);
    if (has("<orthographic>")) sentences.push_back(import_forms::kOrthographic);
    return sentences;
}

std::vector<Sentence> unreadInX3d(const std::filesystem::path& path) {
    if (!isX3d(path)) return {};
    const FileBytes file = openFileBytes(path);
    const auto nodes = xml::treeOf(textOf(file));
    std::string unread;
    bool levels = false;
    for (const std::string_view name : kX3dSurfaces) {
        if (!nodes || std::ranges::find(*nodes, name, &xml::Node::name) == nodes->end()) continue;
        unread += (unread.empty() ? "" : ", ") + std::string(name);
    }
    for (std::size_t i = 0; nodes && i < nodes->size(); ++i) {
        const xml::Node& node = (*nodes)[i];
        const bool several =
            node.firstChild != xml::kNoNode && (*nodes)[node.firstChild].nextSibling != xml::kNoNode;
        levels = levels || (node.name == "LOD" && several);
    }
    std::vector<Sentence> sentences;
    if (!unread.empty())
        sentences.push_back(say("what these X3D nodes show is left out, as they are not read: {0}", unread));
    if (nodes) {
        const std::vector<std::string> files = x3dFilesLeftOut(*nodes, path);
        if (!files.empty())
            sentences.push_back(
                say("what files show that it names (Inline) is left out, as they are missing or "
                    "outside of the model's folder: {0}",
                    firstOf(files)));
    }
    if (levels) sentences.push_back(say("of levels of detail (LOD) the first is shown"));
    return sentences;
}

} // namespace rtcore
