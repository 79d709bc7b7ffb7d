#include "rtcore/io/import/hand_over_folder.h"

#include "rtcore/platform/error.h"
#include "rtcore/platform/processes.h"

#include <charconv>
#include <cstdint>
#include <random>
#include <string>
#include <system_error>

namespace rtcore {

namespace {

namespace fs = std::filesystem;

bool createPrivate(const fs::path& path) {
    std::error_code error;
    if (!fs::create_directory(path, error)) return false;
    fs::permissions(path, fs::perms::owner_all, error);
    return !error;
}

const std::string kPrefix = "rtimport-";

/// Removes what programs left that were killed: a name tells the process that made the folder.
void sweep(const fs::path& parent) {
    std::error_code error;
    for (fs::directory_iterator entry(parent, error), end; !error && entry != end; entry.increment(error)) {
        const std::string name = entry->path().filename().string();
        if (!name.starts_with(kPrefix)) continue;
        std::int64_t maker = 0;
        const char* const last = name.data() + name.size();
        const auto number = std::from_chars(name.data() + kPrefix.size(), last, maker);
        if (number.ec != std::errc() || number.ptr == last || *number.ptr != '-' || maker <= 0) continue;
        std::error_code ignored; // it is somebody else's
        if (!processRuns(maker)) fs::remove_all(entry->path(), ignored);
    }
}

/// Empty when the folder takes no new one.
fs::path createIn(const fs::path& parent) {
    sweep(parent);
    std::random_device random;
    for (int attempt = 0; attempt < 8; ++attempt) {
        const std::string name = kPrefix + std::to_string(processId()) + "-" + std::to_string(random());
        if (createPrivate(parent / name)) return parent / name;
    }
    return {};
}

} // namespace

HandOverFolder::HandOverFolder(std::uint64_t bytes) {
    std::error_code error;
    const fs::path memory = "/dev/shm";
    if (const fs::space_info space = fs::space(memory, error); !error && space.available >= bytes) {
        path_ = createIn(memory);
    }
    if (!path_.empty()) return;
    const fs::path temporary = fs::temp_directory_path(error);
    if (!error) path_ = createIn(temporary);
    if (path_.empty()) {
        throw FileError(FailureKind::CannotWrite, error ? "/tmp" : temporary.string(),
                        "no folder can be made here; free some space or set TMPDIR to another folder");
    }
}

HandOverFolder::~HandOverFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

} // namespace rtcore
