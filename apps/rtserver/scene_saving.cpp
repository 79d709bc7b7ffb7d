#include "rtserver/scene_saving.h"

#include "common/cli/command_line.h"

#include "rtcore/io/text/written_mark.h"
#include "rtcore/platform/error.h"
#include "rtcore/platform/files.h"
#include "rtcore/settings/plain_text.h"

#include <array>
#include <cstddef>
#include <span>
#include <string>

namespace rtserver {

namespace {

namespace fs = std::filesystem;

void keepOld(const fs::path& path, bool replace) {
    if (!rtcore::isWrittenByHand(path)) return;
    if (!replace) {
        throw rtcore::FileError(
            rtcore::FailureKind::CannotWrite, path.string(),
            "it was written or changed by hand, and its comments and its layout would be lost; "
            "add 'replace', then it is kept as " +
                rtcore::inQuotes(path.filename().string() + "~"));
    }
    const rtcore::FileBytes old = rtcore::openFileBytes(path);
    const std::array<std::span<const std::byte>, 1> pieces{old.bytes};
    rtcore::writeFileAtomically(path.string() + "~", pieces);
}

} // namespace

void saveScene(const fs::path& path, const rtcore::SceneFile& scene, bool replace) {
    if (path.extension() != ".scn")
        throw app::UsageError("a scene is saved as a .scn file, not as " +
                              rtcore::inQuotes(path.filename().string()));
    keepOld(path, replace);
    rtcore::writeSceneFile(path, scene);
}

} // namespace rtserver
