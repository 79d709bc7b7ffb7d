/// A report of what an import left out or changed, and its form on the way from the importer program to its
/// caller.
#pragma once

#include "rtcore/platform/sentence.h"
#include "rtcore/scene/model_origin.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rtcore {

struct ImportReport {
    ModelOrigin origin;
    std::uint64_t degenerateTriangles = 0;  ///< without area: dropped
    std::uint64_t ignoredPrimitives = 0;    ///< points and lines: dropped
    std::uint64_t nonFiniteTriangles = 0;   ///< a coordinate is no number or beyond 1e12: dropped
    std::uint64_t unconnectedTriangles = 0; ///< name vertices that do not exist: dropped
    std::uint64_t equalTriangles = 0;       ///< the third and further of equal ones: dropped
    std::vector<Sentence> warnings;         ///< for the user, without a file name
    std::vector<std::string> files;         ///< all that was opened, absolute: the model, buffers, images
    std::vector<std::string> images;        ///< those of `files` that were decoded as images

    friend bool operator==(const ImportReport&, const ImportReport&) = default;
};

/// How many there are and the first of them, for a sentence: "'a', 'b', 'c' and 19 more"; at least one.
Sentence firstOf(std::span<const std::string> names);

/// A warning; beyond the 50th they are counted only. A warning that is there already is not repeated.
void addWarning(ImportReport& report, const Sentence& warning);

/// Its line in a report and in a .bsp, and the warning of a line, which may be plain text: earlier versions
/// wrote that.
std::string warningLine(const Sentence& warning);
Sentence readWarning(std::string_view line);

/// A file that is there already is not repeated.
void addFile(ImportReport& report, const std::string& path);
void addImage(ImportReport& report, const std::string& path); ///< to both lists

/// Lines "name value"; names of files with \\ and \n for a backslash and a line feed.
std::string writeReport(const ImportReport& report);
/// Takes any text: lines that it does not know are skipped.
ImportReport readReport(const std::string& text);

/// The line by which the importer says why it refuses a model.
std::string refusalLine(const Sentence& why);
/// What the last such line of `text`, which may be any, says.
std::optional<Sentence> readRefusal(std::string_view text);

} // namespace rtcore
