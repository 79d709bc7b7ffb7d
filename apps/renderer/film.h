/// A film that ffmpeg makes of frames as they come.
#pragma once

#include "renderer/film_format.h"

#include "rtcore/platform/processes.h"
#include "rtcore/scene/image.h"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

namespace renderer {

/// For one thread. ffmpeg starts with the first frame, whose size is that of all.
class Film {
  public:
    /// `film` is named in messages and says by its extension what is made; `target` is written.
    Film(std::filesystem::path ffmpeg, std::filesystem::path film, std::filesystem::path target,
         double framesPerSecond);

    /// Throws rtcore::FileError: BadData when frame `number` has another size than the first, CannotWrite
    /// with ffmpeg's own words when it failed or died, Stopped.
    void add(const rtcore::LdrImage& frame, int number);

    /// Waits until ffmpeg has written the film. Throws rtcore::FileError CannotWrite as add() does and when
    /// there is no frame, Stopped.
    void finish();

  private:
    void start(const rtcore::LdrImage& frame);
    [[noreturn]] void fail(const rtcore::ProcessResult& result) const;

    std::filesystem::path ffmpeg_, film_, target_;
    FilmShape shape_;
    int frameWidth_ = 0, frameHeight_ = 0; ///< before the padding to even sizes
    std::optional<rtcore::PipedProcess> process_;
    std::vector<std::byte> bytes_;
};

/// The frame as RGB, row by row, with its last row and column repeated up to `width` x `height`.
void packFrame(const rtcore::LdrImage& frame, int width, int height, std::vector<std::byte>& bytes);

} // namespace renderer
