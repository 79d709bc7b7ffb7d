#include "rtcore/io/recording/path_recorder.h"

#include "rtcore/io/recording/camera_list.h"
#include "rtcore/platform/error.h"
#include "rtcore/platform/sentence.h"

#include <fmt/core.h>

#include <string>
#include <system_error>

namespace rtcore {

namespace {

std::filesystem::path makeFolder(const std::filesystem::path& list) {
    const std::filesystem::path folder = recordedFolder(list);
    std::error_code error;
    const bool made = std::filesystem::create_directory(folder, error);
    if (made) return folder;
    throw FileError(
        FailureKind::CannotWrite, list.string(),
        error ? say("its folder {0} cannot be made: {1}", folder.string(), systemReason(error.value()))
              : say("its folder {0} exists already; choose another name", folder.string()));
}

/// Throws CannotWrite for what could not be read back.
std::string checkedText(const CameraFile& frame, const std::filesystem::path& path) {
    std::string text = formatCameraFile(frame);
    try {
        parseCameraFile(text, path);
    } catch (const FileError& error) {
        throw FileError(FailureKind::CannotWrite, path.string(),
                        say("not written, since it could not be read back: {0}", error.sentence()));
    }
    return text;
}

} // namespace

std::filesystem::path recordedFolder(const std::filesystem::path& list) {
    std::filesystem::path folder = list;
    return folder.replace_extension(list.extension() == ".cams" ? ".cams.cams" : ".cams");
}

PathRecorder::PathRecorder(const std::filesystem::path& list)
    : list_(std::filesystem::absolute(list)), folder_(recordedFolder(list_)), lines_(list_) {
    try {
        makeFolder(list_);
        // A name that no list can hold shows here, not at the first frame.
        cameraListLine(list_, folder_ / "000001.cam");
        lines_.append(std::string(kRecordingMark) + "\n");
    } catch (const FileError&) {
        std::error_code ignored;
        std::filesystem::remove(list_, ignored);
        throw;
    }
}

PathRecorder::~PathRecorder() {
    try {
        if (!finished_) finish();
    } catch (const FileError&) {
        // The list is valid without its end mark.
    }
}

void PathRecorder::add(const CameraFile& frame) {
    const std::filesystem::path path = folder_ / fmt::format("{:06}.cam", number_ + 1);
    const std::string text = checkedText(frame, path);
    ++number_;
    AppendFile(path).append(text);
    lines_.append(cameraListLine(list_, path));
    ++frames_;
}

void PathRecorder::finish() {
    finished_ = true;
    lines_.append(std::string(kEndMark) + "\n");
    lines_.flush();
}

} // namespace rtcore
