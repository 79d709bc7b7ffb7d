#include "renderer/film_format.h"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>
#include <sstream>
#include <string_view>

namespace renderer {

namespace {

using Words = std::vector<std::string>;

struct FilmFormat {
    std::string_view extension; ///< with dot, lower case
    bool even;                  ///< has colours of half the resolution
    std::string_view coding;    ///< words without spaces
};

constexpr FilmFormat kFormats[] = {
    {".mp4", true, "-c:v libx264 -preset medium -crf 18 -movflags +faststart -f mp4"},
    {".webm", true, "-c:v libvpx-vp9 -crf 24 -b:v 0 -row-mt 1 -f webm"},
    {".mkv", false, "-c:v ffv1 -level 3 -g 1 -pix_fmt bgr0 -f matroska"},
    // A palette for each frame: one for all would make ffmpeg keep the whole film in memory.
    {".gif", false, "-vf split[a][b];[a]palettegen=stats_mode=single[p];[b][p]paletteuse=new=1 -f gif"},
};

// Frames are sRGB; left alone, ffmpeg would convert them by the matrix of standard definition and not say so.
constexpr std::string_view kColour = "scale=out_color_matrix=bt709:out_range=tv -pix_fmt yuv420p -colorspace "
                                     "bt709 -color_trc bt709 -color_primaries bt709 -color_range tv ";
constexpr std::string_view kPadding = "pad=ceil(iw/2)*2:ceil(ih/2)*2,";

Words splitWords(const std::string& text) {
    std::istringstream stream(text);
    return {std::istream_iterator<std::string>(stream), {}};
}

Words codingOf(const FilmFormat& format, bool padded) {
    std::string all;
    if (format.even) all.append("-vf ").append(padded ? "" : kPadding).append(kColour);
    return splitWords(all.append(format.coding));
}

void append(Words& words, const Words& more) { words.insert(words.end(), more.begin(), more.end()); }

const FilmFormat* findFilmFormat(const std::filesystem::path& film) {
    std::string extension = film.extension().string();
    for (char& c : extension) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    const auto* found = std::find_if(std::begin(kFormats), std::end(kFormats),
                                     [&](const FilmFormat& format) { return extension == format.extension; });
    return found == std::end(kFormats) ? nullptr : found;
}

std::string rateText(double framesPerSecond) { return fmt::format("{:.6g}", framesPerSecond); }

// As a shell reads it back.
std::string shellQuoted(const std::string& word) {
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
    for (const FilmFormat& format : kFormats) {
        list.append(list.empty() ? "" : ", ").append(format.extension);
    }
    return list;
}

bool isFilm(const std::filesystem::path& film) { return findFilmFormat(film) != nullptr; }

bool needsEvenSize(const std::filesystem::path& film) {
    const FilmFormat* format = findFilmFormat(film);
    return format != nullptr && format->even;
}

std::vector<std::string> encodeArguments(const std::filesystem::path& film, const FilmShape& shape,
                                         const std::filesystem::path& target) {
    Words words =
        splitWords(fmt::format("-hide_banner -loglevel error -nostdin -y -f rawvideo -pixel_format rgb24 "
                               "-video_size {}x{} -framerate {} -i pipe:0 -an",
                               shape.width, shape.height, rateText(shape.framesPerSecond)));
    if (const FilmFormat* format = findFilmFormat(film)) append(words, codingOf(*format, true));
    // Without "file:" a name such as "a:b.mp4" would be an address.
    words.push_back("file:" + target.string());
    return words;
}

std::string encodeCommand(const std::filesystem::path& film, double framesPerSecond) {
    Words words = {"ffmpeg", "-framerate", rateText(framesPerSecond), "-i", "frame_%04d.png"};
    if (const FilmFormat* format = findFilmFormat(film)) append(words, codingOf(*format, false));
    words.push_back("file:" + film.string());
    std::string command;
    for (const std::string& word : words) command += (command.empty() ? "" : " ") + shellQuoted(word);
    return command;
}

} // namespace renderer
