/// Names of segments: `rts.<user>.<instance>.<what>`. Different users and instances never meet.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace ipc {

class Names {
  public:
    /// Throws Error BadName unless `instance` is 1 to 32 letters, digits, '_' or '-'.
    explicit Names(std::string_view instance);

    const std::string& instance() const { return instance_; }
    /// All segments of the instance begin with it.
    const std::string& prefix() const { return prefix_; }
    std::string control() const { return prefix_ + "ctl"; }
    std::string frames(std::uint64_t epoch, std::uint64_t generation) const;
    std::string queuePrefix(int slot) const;
    std::string queue(int slot, std::uint64_t tag) const;
    /// The slot of a queue's name; -1 when it is not one.
    int slotOfQueue(std::string_view name) const;

  private:
    std::string instance_, prefix_;
};

/// Begins the name of every segment of this user.
std::string userPrefix();

/// Never 0.
std::uint64_t randomTag();

} // namespace ipc
