#include "rtcore/io/import/exchange_folder.h"

#include "rtcore/platform/error.h"

#include <string>
#include <system_error>

namespace rtcore {

namespace {

namespace fs = std::filesystem;

const std::string kPrefix = "rtimport-";

} // namespace

ExchangeFolder::ExchangeFolder(std::uint64_t bytes) {
    std::error_code error;
    const fs::path memory = "/dev/shm";
    if (const fs::space_info space = fs::space(memory, error); !error && space.available >= bytes) {
        try {
            folder_.emplace(memory, kPrefix);
        } catch (const FileError&) { // there is another place
        }
    }
    if (!folder_) folder_.emplace(kPrefix);
}

} // namespace rtcore
