/// A file from front to back, in pieces that stay in the cache.
#pragma once

#include "rtcore/platform/files.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace rtcore {

/// Bytes are copied out of the file, so that one that shrinks meanwhile ends early and does no other harm.
class PieceReader {
  public:
    /// Begins at `offset`. `alive` is called now and then. Both must outlive the object.
    PieceReader(const InputFile& file, std::uint64_t offset, const std::function<void()>& alive);

    /// The next bytes: at least `min`, fewer only where the file ends. Valid until the next call.
    std::span<const std::byte> ahead(std::size_t min);
    /// Goes on behind `count` bytes, which may be more than ahead() gave.
    void skip(std::uint64_t count);
    /// Goes on behind `count` records of `size` bytes, if they are all there and of use: calls `use` with the
    /// number of a record and the bytes of as many as fit into a piece from there on, by the threads of
    /// OpenMP in any order. Where one says no or the file ends, it stays where it is and returns false.
    using UseRecords = std::function<bool(std::uint64_t first, std::span<const std::byte> records)>;
    bool readRecords(std::uint64_t count, std::size_t size, const UseRecords& use);

    /// Bytes from here to the end, as the file was when it was opened.
    std::uint64_t left() const;

  private:
    std::uint64_t position() const { return offset_ - (end_ - at_); }

    const InputFile& file_;
    const std::function<void()>& alive_;
    std::uint64_t offset_; ///< in the file, of the first byte that is not in `buffer_`
    std::uint64_t told_;   ///< where `alive` was called
    std::vector<std::byte> buffer_;
    std::size_t at_ = 0, end_ = 0; ///< what of the buffer is ahead
};

} // namespace rtcore
