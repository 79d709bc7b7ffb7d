#include "rtcore/io/import/piece_reader.h"

#include <algorithm>
#include <cstring>

namespace rtcore {

namespace {

constexpr std::size_t kPiece = std::size_t{256} << 10;
constexpr std::uint64_t kBytesBetweenWords = std::uint64_t{64} << 20;

} // namespace

PieceReader::PieceReader(const InputFile& file, std::uint64_t offset, const std::function<void()>& alive)
    : file_(file), alive_(alive), offset_(offset), told_(offset), buffer_(kPiece) {}

std::span<const std::byte> PieceReader::ahead(std::size_t least) {
    if (end_ - at_ < least) {
        std::memmove(buffer_.data(), buffer_.data() + at_, end_ - at_);
        end_ -= at_;
        at_ = 0;
        if (buffer_.size() < least) buffer_.resize(least);
        const std::size_t got = file_.readAt(offset_, std::span(buffer_).subspan(end_));
        end_ += got;
        offset_ += got;
        if (offset_ - told_ >= kBytesBetweenWords) {
            alive_();
            told_ = offset_;
        }
    }
    return {buffer_.data() + at_, end_ - at_};
}

void PieceReader::skip(std::uint64_t count) {
    const auto buffered = static_cast<std::size_t>(std::min<std::uint64_t>(count, end_ - at_));
    at_ += buffered;
    offset_ += count - buffered;
}

std::uint64_t PieceReader::left() const {
    const std::uint64_t from = offset_ - (end_ - at_);
    return file_.size() > from ? file_.size() - from : 0;
}

} // namespace rtcore
