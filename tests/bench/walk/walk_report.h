/// The results of bench_walk, as text, a table and a picture.
#pragma once

#include "bench/walk/walk_errors.h"

#include <filesystem>
#include <string>
#include <vector>

namespace bench {

/// One moment of the walk: its end, until which its camera is that of the walk.
struct Moment {
    int camera = 0;
    double milliseconds = 0; ///< from the picture before to the one that is on the screen
    double drawn = 0;        ///< milliseconds that the picture took to trace
    double age = 0;          ///< milliseconds that it has been there
    double scale = 1;        ///< its pixels to the window's, each way
    PictureErrors errors;
};

/// The errors of each moment, a line for each.
std::string tableOf(const std::vector<Moment>& moments);
/// The means and worst twentieths over all moments, a line for each figure.
std::string summaryOf(const std::vector<Moment>& moments);
/// Throws rtcore::FileError.
void writeCsv(const std::filesystem::path& path, const std::vector<Moment>& moments);

/// Pictures below each other: what was shown, what should have been, and FLIP's errors from black to white.
class ContactSheet {
  public:
    void add(const rtcore::LdrImage& shown, const rtcore::LdrImage& reference,
             const std::vector<float>& errors);
    /// Throws rtcore::FileError.
    void write(const std::filesystem::path& path) const;

  private:
    std::vector<rtcore::LdrImage> rows_;
};

} // namespace bench
