#include "ipc/channel/keys.h"

#include "ipc/channel/shared_copy.h"

#include <algorithm>

namespace ipc {

namespace {

bool known(int key) { return key >= 0 && key < kMaxKeys; }
std::uint64_t bit(int key) { return std::uint64_t{1} << (key % 64); }
std::size_t word(int key) { return static_cast<std::size_t>(key / 64); }

} // namespace

void KeyWriter::press(KeyBoard* board, int key) {
    if (!known(key)) return;
    down_[word(key)] |= bit(key);
    if (board == nullptr) return;
    board->presses[key].fetch_add(1, std::memory_order_relaxed);
    board->down[key / 64].fetch_or(bit(key), std::memory_order_release);
}

void KeyWriter::release(KeyBoard* board, int key) {
    if (!known(key)) return;
    down_[word(key)] &= ~bit(key);
    if (board == nullptr) return;
    board->down[key / 64].fetch_and(~bit(key), std::memory_order_release);
}

void KeyWriter::releaseAll(KeyBoard* board) {
    down_ = {};
    if (board != nullptr) repair(*board);
}

void KeyWriter::restore(KeyBoard& board) const {
    for (auto& counter : board.presses) counter.store(0, std::memory_order_relaxed);
    repair(board);
}

void KeyWriter::repair(KeyBoard& board) const {
    for (std::size_t i = 0; i < down_.size(); ++i) keep(board.down[i], down_[i]);
}

void KeyReader::collect(const KeyBoard& board, KeyState& state, std::uint32_t restraint) {
    constexpr std::size_t kKeysOfWord = 64;
    for (std::size_t word = 0; word < kMaxKeys / kKeysOfWord; ++word) {
        // The press is counted before the bit is set, so that a reader that sees the key down sees its press,
        // too.
        state.down |= decltype(state.down)(board.down[word].load(std::memory_order_acquire))
                      << word * kKeysOfWord;
        for (std::size_t key = word * kKeysOfWord; key < (word + 1) * kKeysOfWord; ++key) {
            const std::uint32_t count = board.presses[key].load(std::memory_order_relaxed);
            state.presses[key] += count - seen_[key];
            for (std::uint32_t level = 0; level < std::min(restraint, kKeyRestraints); ++level)
                state.restrained[level][key] += count - seen_[key];
            seen_[key] = count;
        }
    }
}

} // namespace ipc
