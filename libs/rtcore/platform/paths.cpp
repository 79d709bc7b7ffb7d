#include "rtcore/platform/paths.h"

#include "rtcore/platform/files.h"

namespace rtcore {

std::filesystem::path plainPath(const std::filesystem::path& path) {
    const std::filesystem::path whole = std::filesystem::absolute(path), plain = whole.lexically_normal();
    const auto file = identityOf(whole), folder = identityOf(whole.parent_path());
    const bool same = file ? file == identityOf(plain) : !folder || folder == identityOf(plain.parent_path());
    return same ? plain : whole;
}

} // namespace rtcore
