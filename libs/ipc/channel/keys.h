/// The key state of one client: a down bit and a press counter for each key.
#pragma once

#include "ipc/layout/control_block.h"
#include "ipc/layout/key_state.h"

#include <array>
#include <cstdint>

namespace ipc {

/// Key codes are 0..255; others are ignored. Without a board it keeps in mind what is down. One thread.
class KeyWriter {
  public:
    void press(KeyBoard* board, int key);
    void release(KeyBoard* board, int key);
    void releaseAll(KeyBoard* board);
    /// Makes a new board hold what is down now, with all counters 0.
    void restore(KeyBoard& board) const;
    /// Restores the keys that are down, where another process overwrote them.
    void repair(KeyBoard& board) const;

  private:
    std::array<std::uint64_t, kMaxKeys / 64> down_{};
};

/// One client's board as the server sees it.
class KeyReader {
  public:
    /// Adds what is down and what was pressed since the last call, by a client of such a restraint.
    void collect(const KeyBoard& board, KeyState& state, std::uint32_t restraint = 0);

  private:
    std::array<std::uint32_t, kMaxKeys> seen_{};
};

} // namespace ipc
