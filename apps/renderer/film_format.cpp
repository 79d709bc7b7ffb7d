#include "renderer/film_format.h"

#include "renderer/output_names.h"

#include "common/command_line.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <span>

namespace renderer {

namespace {

using Words = std::vector<std::string>;

struct FilmFormat {
    const char* extension; ///< with dot, lower case
    bool even;
    Words coding;
};

// Frames are sRGB; ffmpeg would convert them by the matrix of standard definition and not say so.
const Words kColour = {"-vf",
                       "scale=out_color_matrix=bt709:out_range=tv",
                       "-pix_fmt",
                       "yuv420p",
                       "-colorspace",
                       "bt709",
                       "-color_trc",
                       "bt709",
                       "-color_range",
                       "tv",
                       "-color_primaries",
                       "bt709"};

Words join(const Words& first, const Words& second) {
    Words words = first;
    words.insert(words.end(), second.begin(), second.end());
    return words;
}

const std::array<FilmFormat, 4>& formats() {
    static const std::array<FilmFormat, 4> table{{
        {".mp4", true,
         join(kColour, {"-c:v", "libx264", "-preset", "medium", "-crf", "18", "-movflags", "+faststart", "-f",
                        "mp4"})},
        {".webm", true,
         join(kColour, {"-c:v", "libvpx-vp9", "-crf", "24", "-b:v", "0", "-row-mt", "1", "-f", "webm"})},
        {".mkv", false, {"-c:v", "ffv1", "-level", "3", "-g", "1", "-pix_fmt", "bgr0", "-f", "matroska"}},
        // A palette for each frame: one for all would make ffmpeg keep the whole film in memory.
        {".gif",
         false,
         {"-vf", "split[a][b];[a]palettegen=stats_mode=single[p];[b][p]paletteuse=new=1", "-f", "gif"}},
    }};
    return table;
}

const FilmFormat* findFilmFormat(const std::filesystem::path& film) {
    std::string extension = film.extension().string();
    for (char& c : extension) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    const auto found = std::find_if(formats().begin(), formats().end(),
                                    [&](const FilmFormat& format) { return extension == format.extension; });
    return found == formats().end() ? nullptr : &*found;
}

std::string rateText(double framesPerSecond) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", framesPerSecond);
    return text;
}

// As a shell reads it back.
std::string quoted(const std::string& word) {
    static constexpr const char* kPlain =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_+-./:=%";
    if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
    std::string text = "'";
    for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return text + "'";
}

} // namespace

std::string filmExtensions() {
    std::string list;
    for (const FilmFormat& format : formats()) {
        list.append(list.empty() ? "" : ", ").append(format.extension);
    }
    return list;
}

void checkFilm(const std::filesystem::path& film) {
    if (findFilmFormat(film) == nullptr) {
        throw app::UsageError(film.string() + ": cannot write films with this extension, only " +
                              filmExtensions());
    }
    checkPlace(film);
}

bool needsEvenSize(const std::filesystem::path& film) {
    const FilmFormat* format = findFilmFormat(film);
    return format != nullptr && format->even;
}

std::vector<std::string> encodeArguments(const std::filesystem::path& film, const FilmShape& shape,
                                         const std::filesystem::path& target) {
    Words words = {"-hide_banner",
                   "-loglevel",
                   "error",
                   "-nostdin",
                   "-y",
                   "-f",
                   "rawvideo",
                   "-pixel_format",
                   "rgb24",
                   "-video_size",
                   std::to_string(shape.width) + "x" + std::to_string(shape.height),
                   "-framerate",
                   rateText(shape.framesPerSecond),
                   "-i",
                   "pipe:0",
                   "-an"};
    if (const FilmFormat* format = findFilmFormat(film)) words = join(words, format->coding);
    // Without "file:" a name such as "a:b.mp4" would be an address.
    words.push_back("file:" + target.string());
    return words;
}

std::string encodeCommand(const std::filesystem::path& film, double framesPerSecond) {
    Words words = {"ffmpeg", "-framerate", rateText(framesPerSecond), "-i", "frame_%04d.png"};
    if (const FilmFormat* format = findFilmFormat(film)) words = join(words, format->coding);
    words.push_back("file:" + film.string());
    std::string command;
    for (const std::string& word : words) command += (command.empty() ? "" : " ") + quoted(word);
    return command;
}

} // namespace renderer
