/// A path that is being recorded: cameras at an even pace, whatever the rate of frames.
#pragma once

#include "rtcore/io/recording/path_recorder.h"

#include <chrono>
#include <filesystem>
#include <vector>

namespace rtserver {

/// The exposure of a moment is known when the frame after it has been developed: until then its camera
/// waits. One thread.
class Recording {
  public:
    /// Makes the list; see rtcore::PathRecorder for what it throws.
    Recording(const std::filesystem::path& list, double framesPerSecond);

    /// Until the next camera is due. The first one is due at once.
    std::chrono::nanoseconds untilNext() const { return next_ - now_; }
    /// That was told of by advance().
    std::chrono::nanoseconds time() const { return now_; }
    /// Time goes on.
    void advance(std::chrono::nanoseconds time) { now_ += time; }
    /// Takes the camera that is due; its time and exposure are seen to.
    void add(rtcore::CameraFile camera);
    /// Writes the cameras that wait: the exposure went from that of the last call to `now` meanwhile, evenly
    /// in the logarithm. Throws FileError CannotWrite; the cameras are lost then.
    void settle(float exposure);
    /// Writes the rest and the end mark. Throws FileError CannotWrite.
    void finish();

    const std::filesystem::path& list() const { return recorder_.list(); }
    int frames() const { return recorder_.frames(); }

  private:
    rtcore::PathRecorder recorder_;
    std::chrono::duration<double> interval_;
    std::chrono::nanoseconds now_{0}, next_{0};
    std::int64_t taken_ = 0;
    std::vector<rtcore::CameraFile> waiting_;
    float exposure_ = 0; ///< 0: not known yet
};

} // namespace rtserver
