#include "rtcore/platform/temporary_folder.h"

#include "rtcore/platform/error.h"
#include "rtcore/platform/processes.h"
#include "rtcore/platform/sentence.h"

#include <fmt/core.h>

#include <cerrno>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <system_error>

namespace rtcore {

namespace {

namespace fs = std::filesystem;

/// Removes what programs left that were killed: a name tells the process that made the folder.
void sweep(const fs::path& parent, const std::string& prefix) {
    std::error_code error;
    for (fs::directory_iterator entry(parent, error), end; !error && entry != end; entry.increment(error)) {
        const std::string name = entry->path().filename().string();
        if (!name.starts_with(prefix)) continue;
        std::int64_t maker = 0;
        const char* const last = name.data() + name.size();
        const auto number = std::from_chars(name.data() + prefix.size(), last, maker);
        if (number.ec != std::errc() || number.ptr == last || *number.ptr != '-' || maker <= 0) continue;
        std::error_code ignored; // it belongs to another user
        if (!processRuns(maker)) fs::remove_all(entry->path(), ignored);
    }
}

fs::path commonParent() {
    std::error_code error;
    const fs::path folder = fs::temp_directory_path(error);
    return error ? "/tmp" : folder;
}

fs::path create(const fs::path& parent, const std::string& prefix) {
    sweep(parent, prefix);
    std::string name = (parent / fmt::format("{}{}-XXXXXX", prefix, processId())).string();
    if (::mkdtemp(name.data()) != nullptr) return name;
    const Sentence reason = systemReason(errno);
    // TMPDIR names the folder for temporary files, and no other.
    const Sentence remedy = say(parent == commonParent() ? "free some space or set TMPDIR to another folder"
                                                         : "check its permissions, or name another place");
    throw FileError(FailureKind::CannotWrite, parent.string(),
                    say("no folder can be made here: {0}; {1}", reason, remedy));
}

} // namespace

TemporaryFolder::TemporaryFolder(const std::string& prefix) : TemporaryFolder(commonParent(), prefix) {}

TemporaryFolder::TemporaryFolder(const fs::path& parent, const std::string& prefix)
    : path_(create(parent, prefix)), name_(path_.string(), TemporaryKind::Folder) {}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

fs::path TemporaryFolder::file(const std::string& name) {
    const fs::path path = path_ / name;
    files_.emplace_back(path.string());
    return path;
}

} // namespace rtcore
