/// The kinds of films, and how ffmpeg is asked for them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace renderer {

/// The size and the rate of a film's frames.
struct FilmShape {
    int width = 0, height = 0; ///< pixels of its frames
    double framesPerSecond = 25;
};

/// Whether some kind of film goes by the extension.
bool isFilm(const std::filesystem::path& film);

/// ".mp4, .webm, ...".
std::string filmExtensions();

/// Whether this kind stores colours at half the resolution, so that width and height must be even.
bool needsEvenSize(const std::filesystem::path& film);

/// ffmpeg's arguments: frames of `shape` as RGB of 8 bits on its standard input, a film of the kind that the
/// extension of `film` says into the file `target`.
std::vector<std::string> encodeArguments(const std::filesystem::path& film, const FilmShape& shape,
                                         const std::filesystem::path& target);

/// The command that makes the film from frames in files with numbers of four digits.
std::string encodeCommand(const std::filesystem::path& film, double framesPerSecond);

} // namespace renderer
