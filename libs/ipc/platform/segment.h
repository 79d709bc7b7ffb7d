/// A named piece of shared memory. Only this user can open it. Its maker removes it; maps are closed
/// by the destructor, names are not.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace ipc {

enum class Access { Read, Write };

class Segment {
  public:
    /// New, zeroed, mode 0600, its memory reserved. Throws Error: NotYours when the name is taken, NoSpace,
    /// System.
    static Segment create(const std::string& name, std::size_t bytes);
    /// The same with a byte of it locked by us as soon as it is there. Nothing when the name is taken, or
    /// when another process found it before it was locked, and removed it. Throws Error: NoSpace, System.
    static std::optional<Segment> createLocked(const std::string& name, std::size_t bytes,
                                               std::uint64_t byte);
    /// Nothing when there is no such segment, or when it has less than `atLeast` bytes (its maker is not
    /// done, or died). Never waits. Throws Error: NotYours when it is not a segment of this user alone,
    /// System.
    static std::optional<Segment> open(const std::string& name, Access access, std::size_t atLeast);
    /// Reserves the memory of a segment that another library made. Throws Error NoSpace, System.
    static void reserve(const std::string& name);
    /// No error when there is none, or when it belongs to another user.
    static void remove(const std::string& name) noexcept;

    Segment(Segment&&) noexcept;
    Segment& operator=(Segment&&) noexcept;
    ~Segment();

    void* data() const;
    std::size_t bytes() const;
    /// False once its name was removed.
    bool named() const;

    /// Locks a byte, whether the segment has it or not, until this object and its maps are gone: see
    /// tryLockByte. False when another object or process has it. Throws Error System.
    bool tryLock(std::uint64_t byte) const;
    void unlock(std::uint64_t byte) const;
    /// Whether another object or process has it; true when the system cannot tell.
    bool locked(std::uint64_t byte) const;

  private:
    struct State;
    explicit Segment(std::unique_ptr<State> state);
    static std::unique_ptr<State> make(const std::string& name);
    std::unique_ptr<State> state_;
};

} // namespace ipc
