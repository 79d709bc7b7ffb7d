/// The two tokens: who has one may look, or drive.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace bridge {

struct Tokens {
    std::string driver; ///< "": there is none
    std::string viewer;
    bool lasting = false; ///< of a file: the driver's link is good again and again
};

/// New ones; with a file those in it, two lines, or new ones that are written to it, mode 0600. Throws
/// rtcore::FileError: BadData (not two tokens of at least 22 characters, or others may read the file),
/// NoInput, CannotWrite.
Tokens openTokens(const std::optional<std::filesystem::path>& file, bool viewOnly);

} // namespace bridge
