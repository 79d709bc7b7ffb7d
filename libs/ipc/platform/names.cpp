#include "ipc/platform/names.h"

#include "ipc/layout/limits.h"
#include "ipc/platform/error.h"
#include "ipc/platform/system.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <random>

namespace ipc {

namespace {

bool allowed(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
}

} // namespace

std::string userPrefix() { return fmt::format("rts.{}.", userId()); }

Names::Names(std::string_view instance) : instance_(instance), prefix_(userPrefix() + instance_ + ".") {
    if (instance.empty() || instance.size() > 32 || !std::all_of(instance.begin(), instance.end(), allowed)) {
        throw Error(Problem::BadName,
                    "'{0}' cannot name an instance: use 1 to 32 letters, digits, '_' or '-'", {instance_});
    }
}

std::string Names::frames(std::uint64_t epoch, std::uint64_t generation) const {
    return fmt::format("{}f{:x}-{}", prefix_, epoch, generation);
}

std::string Names::queuePrefix(int slot) const { return fmt::format("{}q{}-", prefix_, slot); }

std::string Names::queue(int slot, std::uint64_t tag) const {
    return fmt::format("{}{:x}", queuePrefix(slot), tag);
}

int Names::slotOfQueue(std::string_view name) const {
    if (!name.starts_with(prefix_)) return -1;
    name.remove_prefix(prefix_.size());
    if (name.empty() || name.front() != 'q') return -1;
    int slot = -1;
    const auto [end, error] = std::from_chars(name.data() + 1, name.data() + name.size(), slot);
    const bool whole = error == std::errc() && end != name.data() + name.size() && *end == '-';
    return whole && slot >= 0 && slot < kMaxClients ? slot : -1;
}

std::uint64_t randomTag() {
    std::random_device source;
    std::uint64_t tag = 0;
    while (tag == 0) tag = (std::uint64_t{source()} << 32) | source();
    return tag;
}

} // namespace ipc
