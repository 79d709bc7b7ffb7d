/// Whether the files of frames are there, and whole.
#pragma once

#include "renderer/frame_list.h"

#include "rtcore/platform/sentence.h"

#include <filesystem>
#include <span>
#include <vector>

namespace app {
class Progress;
}

namespace renderer {

struct FileFlaw {
    int frame = 1;              ///< its number
    std::filesystem::path file; ///< "-" for standard output, which keeps nothing
    bool missing = false;       ///< else it is broken
    rtcore::Sentence reason;    ///< the reader's words; empty when it is missing
};

/// The files that are missing or broken, in the order of the frames. A file is whole when it can be decoded
/// to its last pixel; whether it shows what the frame would show now is not looked at. Reads on `threads`
/// threads (0 = all cores), each with one image in memory. Throws rtcore::FileError: Stopped, TryAgain when
/// memory is short.
std::vector<FileFlaw> findFlaws(std::span<const FrameTask> frames, int threads, app::Progress& progress);

} // namespace renderer
