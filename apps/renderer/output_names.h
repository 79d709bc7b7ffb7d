/// Where images go: the names of the files, by pattern and frame number.
#pragma once

#include <climits>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace renderer {

/// Frame numbers start at 1, as the lines of a list do.
struct FrameRange {
    int first = 1;
    int last = INT_MAX;

    bool contains(int number) const { return number >= first && number <= last; }
    friend bool operator==(const FrameRange&, const FrameRange&) = default;
};

/// "7", "3-9", "3-" and "-9". Throws app::UsageError.
FrameRange parseFrameRange(std::string_view text);

/// The `part`-th of `parts` equal pieces of a list, which together hold each frame once.
struct Chunk {
    int part = 1, parts = 1; ///< 1 <= part <= parts
    friend bool operator==(const Chunk&, const Chunk&) = default;
};

/// "3/10". Throws app::UsageError.
Chunk parseChunk(std::string_view text);

/// The name of frame `number`: the last run of # in the file's name (not in its folders) becomes the number,
/// padded with zeros to the length of the run. `always`: a name without # gets "_####" before its extension.
std::filesystem::path numberedPath(const std::filesystem::path& pattern, int number, bool always);

/// "-" stands for standard output.
inline bool isStandardOutput(const std::filesystem::path& path) { return path == "-"; }

/// The treatment of an output whose folder does not exist.
enum class MissingFolder {
    Refuse,
    Make, ///< before the first frame, by makeFolder(): where a list is rendered into a folder of its own
};

/// Throws before hours are spent on an image that cannot be written: app::UsageError when no image format
/// goes by the name's extension, rtcore::FileError CannotWrite when it is a folder, or its own folder does
/// not exist - and, if that is made, when the folder around that does not.
void checkOutput(const std::filesystem::path& path, MissingFolder missing = MissingFolder::Refuse);

/// Whether there was no such folder, and it was made. Throws rtcore::FileError CannotWrite.
bool makeFolder(const std::filesystem::path& folder);

/// Throws app::UsageError when none of the patterns names a file that can hold AOVs.
void checkAovs(std::span<const std::filesystem::path> patterns);

/// The same when one of the patterns names a file that cannot hold alpha, or, with a backdrop, one of
/// radiance. `standard`: the format of standard output.
void checkAlpha(std::span<const std::filesystem::path> patterns, const std::string& standard);
void checkBackdrop(std::span<const std::filesystem::path> patterns);

/// The same for a film: app::UsageError when no kind of film goes by the extension.
void checkFilm(const std::filesystem::path& film);

/// The same for any file: throws rtcore::FileError CannotWrite.
void checkPlace(const std::filesystem::path& path, MissingFolder missing = MissingFolder::Refuse);

} // namespace renderer
