#include "rtserver/document/packed_files.h"

#include "rtcore/platform/append_file.h"
#include "rtcore/platform/error.h"
#include "rtcore/platform/files.h"
#include "rtcore/platform/paths.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <system_error>
#include <utility>

namespace rtserver {

namespace fs = std::filesystem;

namespace {

/// In pieces, between which it can be given up.
void copyBytes(const fs::path& source, const fs::path& target, PackProgress& progress) {
    constexpr std::size_t kPiece = std::size_t{4} << 20U;
    const rtcore::InputFile in(source);
    rtcore::AppendFile out(target);
    std::vector<char> piece(kPiece);
    for (std::uint64_t at = 0; at < in.size();) {
        throwIfStopped(progress);
        const std::size_t got = in.readAt(at, std::as_writable_bytes(std::span(piece)));
        if (got == 0) break; // it was cut off meanwhile
        out.append({piece.data(), got});
        at += got;
        progress.done += got;
    }
}

} // namespace

void throwIfStopped(const PackProgress& progress) {
    if (progress.stop) throw rtcore::FileError(rtcore::FailureKind::Stopped, "", "the pack was stopped");
}

PackedFiles::PackedFiles(fs::path root, PackProgress& progress)
    : root_(std::move(root)), progress_(progress) {}

fs::path PackedFiles::take(const fs::path& source, const char* folder) {
    const auto known = copies_.find(rtcore::plainPath(source));
    if (known != copies_.end()) return known->second;
    fs::path target = root_ / folder / source.filename();
    for (int number = 2; fs::exists(target); ++number)
        target.replace_filename(source.stem().string() + '-' + std::to_string(number) +
                                source.extension().string());
    return copy(source, target);
}

fs::path PackedFiles::copy(const fs::path& source, const fs::path& target) {
    const fs::path plain = rtcore::plainPath(source);
    const auto known = copies_.find(plain);
    if (known != copies_.end()) return known->second;
    if (!fs::is_regular_file(plain))
        throw rtcore::FileError(rtcore::FailureKind::CannotWrite, plain.string(),
                                "cannot be copied: it is no file, or gone");
    fs::create_directories(target.parent_path());
    copyBytes(plain, target, progress_);
    fs::permissions(target, fs::status(plain).permissions() & fs::status(target).permissions());
    return copies_[plain] = target;
}

void PackedFiles::leaveOut(const fs::path& copy) {
    const auto at =
        std::find_if(copies_.begin(), copies_.end(), [&](const auto& each) { return each.second == copy; });
    if (at == copies_.end()) return;
    noteMissing(at->first);
    copies_.erase(at);
    fs::remove(copy);
    std::error_code holdsOthers;
    fs::remove(copy.parent_path(), holdsOthers);
}

void PackedFiles::noteMissing(const fs::path& source) {
    const fs::path plain = rtcore::plainPath(source);
    if (std::find(leftOut_.begin(), leftOut_.end(), plain) == leftOut_.end()) leftOut_.push_back(plain);
}

} // namespace rtserver
