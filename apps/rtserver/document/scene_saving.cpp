#include "rtserver/document/scene_saving.h"

#include "common/cli/command_line.h"

#include "rtcore/io/text/written_mark.h"
#include "rtcore/platform/backups.h"
#include "rtcore/platform/error.h"
#include "rtcore/platform/files.h"
#include "rtcore/platform/sentence.h"
#include "rtcore/settings/plain_text.h"

#include <optional>
#include <string>
#include <system_error>

namespace rtserver {

namespace {

namespace fs = std::filesystem;

/// The name under which the old file is kept, where it is one by hand.
std::optional<fs::path> keepOld(const fs::path& path, bool replace) {
    if (!rtcore::isWrittenByHand(path)) return std::nullopt;
    if (!replace) {
        throw rtcore::FileError(
            rtcore::FailureKind::CannotWrite, path.string(),
            rtcore::say(
                "it was written or changed by hand, and its comments and its layout would be lost; add "
                "'replace', then it is kept as {0}",
                rtcore::inQuotes(path.filename().string() + "~")));
    }
    return rtcore::keepBackup(path);
}

} // namespace

void saveScene(const fs::path& path, const rtcore::SceneFile& scene, bool replace) {
    if (path.extension() != ".scn")
        throw app::UsageError(rtcore::say("a scene is saved as a .scn file, not as {0}",
                                          rtcore::inQuotes(path.filename().string())));
    const std::optional<fs::path> old = keepOld(path, replace);
    try {
        rtcore::writeSceneFile(path, scene);
    } catch (...) {
        std::error_code ignored;
        if (old) fs::remove(*old, ignored); // the file itself is there
        throw;
    }
}

} // namespace rtserver
