/// Tells a text that a program of the suite wrote, and that was not changed since, from one by hand.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace rtcore {

/// `text` behind a first line, a comment, that holds a checksum of it.
std::string withWrittenMark(std::string_view text);

/// Whether withWrittenMark() made the whole of it: no comment is in it, nothing was written between the
/// lines.
bool hasWrittenMark(std::string_view text);

/// Whether there is a file that has no such mark, and so what only its author could write again. Throws as
/// openFileBytes().
bool isWrittenByHand(const std::filesystem::path& path);

} // namespace rtcore
