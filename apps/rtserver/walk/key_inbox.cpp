#include "rtserver/walk/key_inbox.h"

namespace rtserver {

bool KeyInbox::add(const ipc::KeyState& keys) {
    std::uint32_t pressed = 0;
    for (std::size_t i = 0; i < keys.presses.size(); ++i) {
        keys_.presses[i] += keys.presses[i];
        pressed |= keys.presses[i];
        for (std::size_t level = 0; level < keys.restrained.size(); ++level)
            keys_.restrained[level][i] += keys.restrained[level][i];
    }
    keys_.down = keys.down;
    return pressed != 0 || keys_.down != taken_;
}

ipc::KeyState KeyInbox::take() {
    const ipc::KeyState keys = keys_;
    keys_.presses = {};
    keys_.restrained = {};
    taken_ = keys.down;
    return keys;
}

} // namespace rtserver
