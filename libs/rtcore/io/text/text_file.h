/// Text files on the disk: size limits, UTF-8, paths relative to the file that names them.
#pragma once

#include "rtcore/io/text/text_value.h"

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace rtcore {

/// The content of a text file of at most 16 MB. Throws FileError NoInput or BadData.
std::string readShortText(const std::filesystem::path& path);

/// Replaces `path` by `text` (platform/files.h writeFileAtomically) once `check` has read `text` without
/// throwing FileError, so that nothing is written that could not be read. Throws FileError CannotWrite
/// otherwise.
void writeCheckedText(const std::filesystem::path& path, const std::string& text,
                      const std::function<void(std::string_view)>& check);

/// Where the byte `offset` of `text` is seen. A byte order mark is not counted.
TextPosition positionAt(std::string_view text, std::size_t offset);

/// Text files hold paths in UTF-8 with '/' on every system.
std::filesystem::path pathFromUtf8(std::string_view text);
std::string pathToUtf8(const std::filesystem::path& path);

/// How a file in `folder` names `path` (both absolute or relative to the current folder): relative when
/// `path` is below `folder`, else absolute.
std::filesystem::path pathSeenFrom(const std::filesystem::path& folder, const std::filesystem::path& path);

} // namespace rtcore
