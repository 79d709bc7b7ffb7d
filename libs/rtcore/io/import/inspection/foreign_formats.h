/// Recognises files that no reader takes, by their first bytes, before one of them tries.
#pragma once

#include "rtcore/platform/sentence.h"

#include <filesystem>
#include <optional>
#include <string>

namespace rtcore {

/// Formats of CAD's surfaces that Open CASCADE reads (../cad/cad_import.h).
enum class CadFormat { Step, Iges, Brep };
/// By the first bytes; nothing for what is none.
std::optional<CadFormat> cadFormat(const std::filesystem::path& path);

/// Says what the file is, why it is not read, and what to do, as one sentence without a name; nothing where a
/// reader may know it. Archives are read where a format is one by its ending (.3mf, .kmz, .zae, .ifczip).
std::optional<Sentence> unreadFormat(const std::filesystem::path& path);

/// The ending, with its dot, that fits the first bytes of a file that is called otherwise; nothing where the
/// name fits, or the bytes are those of no format that is known.
std::optional<std::string> endingByContent(const std::filesystem::path& path);

/// Throws FileError BadData where there is such an ending: a reader that is chosen by the name would take the
/// file for what it is not.
void refuseMisnamed(const std::filesystem::path& path);

} // namespace rtcore
