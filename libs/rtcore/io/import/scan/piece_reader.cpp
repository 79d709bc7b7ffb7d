#include "rtcore/io/import/scan/piece_reader.h"

#include "rtcore/platform/task_errors.h"

#include <algorithm>
#include <atomic>
#include <cstring>

namespace rtcore {

namespace {

constexpr std::size_t kPiece = std::size_t{256} << 10;
constexpr std::uint64_t kWorthSharing = std::uint64_t{16} << 20; // bytes
constexpr std::uint64_t kBytesBetweenWords = std::uint64_t{64} << 20;

} // namespace

PieceReader::PieceReader(const InputFile& file, std::uint64_t offset, const std::function<void()>& alive)
    : file_(file), alive_(alive), offset_(offset), told_(offset), buffer_(kPiece) {}

std::span<const std::byte> PieceReader::ahead(std::size_t min) {
    if (end_ - at_ < min) {
        std::memmove(buffer_.data(), buffer_.data() + at_, end_ - at_);
        end_ -= at_;
        at_ = 0;
        if (buffer_.size() < min) buffer_.resize(min);
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

bool PieceReader::readRecords(std::uint64_t count, std::size_t size, const UseRecords& use) {
    if (size == 0 || count > left() / size) return false;
    const std::uint64_t records = std::max<std::uint64_t>(1, kPiece / size); // of a piece
    const std::uint64_t together = std::max<std::uint64_t>(1, kBytesBetweenWords / size / records) * records;
    TaskErrors errors;
    std::atomic<bool> good = true;
    for (std::uint64_t begin = 0; begin < count && good; begin += together) {
        const std::uint64_t end = std::min(count, begin + together);
#pragma omp parallel if ((end - begin) * size > kWorthSharing)
        {
            std::vector<std::byte> buffer;
#pragma omp for schedule(dynamic, 1)
            for (std::uint64_t first = begin; first < end; first += records) {
                if (!good) continue;
                errors.guard([&] {
                    buffer.resize(std::min(records, end - first) * size);
                    const std::size_t got = file_.readAt(position() + first * size, buffer);
                    if (got < buffer.size() || !use(first, buffer)) good = false;
                });
            }
        }
        errors.rethrow();
        alive_();
    }
    if (good) skip(count * size);
    return good;
}

std::uint64_t PieceReader::left() const { return file_.size() > position() ? file_.size() - position() : 0; }

} // namespace rtcore
