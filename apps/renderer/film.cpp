#include "renderer/film.h"

#include "common/process/stop.h"

#include "rtcore/platform/error.h"

#include <fmt/core.h>

#include <algorithm>
#include <string>
#include <system_error>
#include <utility>

namespace renderer {

namespace {

// The last words of a program: its reason stands there, and what comes before is often long.
std::string lastWords(std::string text) {
    constexpr std::size_t kMax = 400;
    while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) text.pop_back();
    if (text.size() > kMax) text = "..." + text.substr(text.size() - kMax);
    for (char& c : text) {
        if (c == '\n' || c == '\r') c = ' ';
    }
    return text;
}

std::string sizeText(int width, int height) { return fmt::format("{} x {}", width, height); }

} // namespace

void packFrame(const rtcore::LdrImage& frame, int width, int height, std::vector<std::byte>& bytes) {
    bytes.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3);
    std::byte* target = bytes.data();
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const rtcore::Rgba8 pixel = frame.at(std::min(x, frame.width - 1), std::min(y, frame.height - 1));
            for (const std::uint8_t channel : {pixel.r, pixel.g, pixel.b}) *target++ = std::byte{channel};
        }
    }
}

Film::Film(std::filesystem::path ffmpeg, std::filesystem::path film, std::filesystem::path target,
           double framesPerSecond)
    : ffmpeg_(std::move(ffmpeg)), film_(std::move(film)),
      target_(std::move(target)), shape_{.framesPerSecond = framesPerSecond} {}

void Film::start(const rtcore::LdrImage& frame) {
    const int even = needsEvenSize(film_) ? 1 : 0;
    frameWidth_ = frame.width;
    frameHeight_ = frame.height;
    shape_.width = frame.width + (frame.width & even);
    shape_.height = frame.height + (frame.height & even);
    process_.emplace(ffmpeg_, encodeArguments(film_, shape_, target_), app::stopRequested);
}

void Film::add(const rtcore::LdrImage& frame, int number) {
    if (!process_) start(frame);
    if (frame.width != frameWidth_ || frame.height != frameHeight_) {
        throw rtcore::FileError(
            rtcore::FailureKind::BadData, film_.string(),
            rtcore::say(
                "frame {0} has {1} pixels, those before it {2}; give all of them one size by -w and -h",
                number, sizeText(frame.width, frame.height), sizeText(frameWidth_, frameHeight_)));
    }
    packFrame(frame, shape_.width, shape_.height, bytes_);
    if (!process_->write(bytes_)) fail(process_->finish());
}

void Film::finish() {
    if (!process_) {
        throw rtcore::FileError(rtcore::FailureKind::CannotWrite, film_.string(), "there is no frame for it");
    }
    const rtcore::ProcessResult result = process_->finish();
    std::error_code unknown;
    const bool empty = std::filesystem::is_regular_file(target_, unknown) &&
                       std::filesystem::file_size(target_, unknown) == 0;
    if (result.end != rtcore::ProcessEnd::Exited || result.code != 0 || empty) fail(result);
}

void Film::fail(const rtcore::ProcessResult& result) const {
    const std::string program = ffmpeg_.string();
    rtcore::Sentence reason = rtcore::say("{0} ended without making the film", program);
    if (result.end == rtcore::ProcessEnd::Signalled)
        reason = rtcore::say("{0} was ended by a signal ({1})", program, rtcore::signalName(result.code));
    else if (result.code != 0)
        reason = rtcore::say("{0} failed with exit code {1}", program, result.code);
    const std::string words = lastWords(result.errors);
    if (!words.empty()) reason = rtcore::say("{0}: \"{1}\"", reason, words);
    throw rtcore::FileError(rtcore::FailureKind::CannotWrite, film_.string(), reason);
}

} // namespace renderer
