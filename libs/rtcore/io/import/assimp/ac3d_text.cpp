#include "rtcore/io/import/assimp/ac3d_text.h"

#include "rtcore/io/import/mesh/utf16_text.h"
#include "rtcore/io/import/text/statement_text.h"
#include "rtcore/platform/files.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

namespace rtcore {

bool subdividesTextures(const std::filesystem::path& path) {
    if (inSmallLetters(path.extension().string()) != ".ac") return false;
    const FileBytes file = openFileBytes(path);
    const auto converted = utf8OfUtf16(file.bytes);
    std::string_view text(reinterpret_cast<const char*>(file.bytes.data()), file.bytes.size());
    if (converted) text = *converted;
    bool hasTexture = false, isSubdivided = false;
    while (!text.empty() && !(hasTexture && isSubdivided)) {
        const std::string_view line = text.substr(0, text.find('\n'));
        text.remove_prefix(std::min(line.size() + 1, text.size()));
        if (line.starts_with("OBJECT")) hasTexture = isSubdivided = false;
        hasTexture = hasTexture || line.starts_with("texture ");
        isSubdivided = isSubdivided || (line.starts_with("subdiv ") && !line.starts_with("subdiv 0"));
    }
    return hasTexture && isSubdivided;
}

} // namespace rtcore
