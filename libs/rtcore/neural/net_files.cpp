#include "rtcore/neural/net_files.h"

#include "rtcore/neural/digest.h"
#include "rtcore/neural/tensor_archive.h"
#include "rtcore/platform/error.h"

#include <cstdlib>
#include <optional>
#include <system_error>

namespace rtcore {

namespace {

namespace fs = std::filesystem;

/// An environment variable; empty where it is not set.
fs::path variable(const char* name) {
    const char* const value = std::getenv(name); // NOLINT(concurrency-mt-unsafe)
    return value != nullptr ? value : "";
}

/// Where programs of this user keep data (XDG Base Directory Specification, which ignores relative paths).
fs::path userDataFolder() {
    const fs::path data = variable("XDG_DATA_HOME"), home = variable("HOME");
    if (data.is_absolute()) return data;
    return home.is_absolute() ? home / ".local" / "share" : fs::path();
}

bool isThere(const fs::path& path) {
    std::error_code unknown;
    return fs::exists(path, unknown);
}

/// The command that brings the nets: the one that is installed beside the programs, else that of the sources.
std::string fetchCommand(const fs::path& programs) {
    constexpr const char* kInstalled = "rtsuite-fetch-nets";
    return isThere(programs / kInstalled) ? kInstalled : "scripts/setup.sh --nets";
}
/// The same for one folder.
std::string fetchCommand(const fs::path& programs, const fs::path& folder) {
    const std::string command = fetchCommand(programs);
    return (command.find('/') == std::string::npos ? command : "scripts/fetch-nets.sh") + " " +
           folder.string();
}

} // namespace

std::vector<fs::path> netFolders(const fs::path& chosen, const fs::path& programs) {
    if (!chosen.empty()) return {chosen};
    if (const fs::path folder = variable("RT_NETS"); !folder.empty()) return {folder};
    std::vector<fs::path> folders;
    if (const fs::path data = userDataFolder(); !data.empty()) folders.push_back(data / "rtsuite" / "nets");
    const fs::path above = programs.parent_path();
    folders.push_back(above / "share" / "rtsuite" / "nets");
    if (isThere(above / "CMakeCache.txt")) folders.push_back(above.parent_path() / "nets");
    return folders;
}

FoundNet findNet(const NetFile& net, const fs::path& chosen, const fs::path& programs) {
    const std::vector<fs::path> folders = netFolders(chosen, programs);
    std::string all;
    for (const fs::path& folder : folders) {
        if (isThere(folder / net.file)) return {folder / net.file, {}};
        all += (all.empty() ? "" : ", ") + folder.string();
    }
    const bool asked = !chosen.empty() || !variable("RT_NETS").empty();
    return {{},
            say("denoise.net: no weights in {0} ({1}); {2} brings them", all, net.file,
                asked ? fetchCommand(programs, folders.front()) : fetchCommand(programs))};
}

std::shared_ptr<const UNet> readNet(const NetFile& net, const fs::path& file) {
    const std::string command = fetchCommand(programFolder(), file.parent_path());
    InputFile input(file);
    // Before it is read: a file of any size may lie there.
    if (input.size() != net.bytes)
        throw FileError(FailureKind::BadData, file.string(),
                        say("this is another net: {0} bytes, not {1}; {2} brings the right one", input.size(),
                            net.bytes, command));
    const FileBytes bytes = input.read();
    const std::optional<std::string> digest = sha256(bytes.bytes);
    if (!digest)
        throw FileError(FailureKind::BadData, file.string(),
                        say("nets cannot be checked by this build, which is without OpenSSL; build the suite "
                            "with libssl-dev"));
    if (*digest != net.sha256)
        throw FileError(FailureKind::BadData, file.string(),
                        say("this is another net: its SHA-256 is {0}, not {1}; {2} brings the right one",
                            *digest, net.sha256, command));
    return std::make_shared<const UNet>(parseTensorArchive(bytes.bytes, file.string()), file.string());
}

} // namespace rtcore
