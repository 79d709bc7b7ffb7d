/// Who drives, among the sessions of one instance. Pure.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace bridge {

using SessionId = std::uint32_t;

struct Person {
    SessionId id = 0;
    std::string name;
    bool mayDrive = false;
};

/// Times are seconds of any clock. One thread. A change of driver is seen by comparing driver() before and
/// after.
class Roles {
  public:
    void join(Person person, double now);
    void leave(SessionId id);
    void rename(SessionId id, std::string name);

    enum class Asked {
        NotAllowed, ///< by a viewer's token
        Drives,     ///< now, or did already
        Waits,      ///< the driver is asked
    };
    Asked ask(SessionId id, double now);
    bool give(SessionId from, SessionId to, double now); ///< false: not the driver, or to one that may not
    bool keep(SessionId id);                             ///< those who ask are refused
    bool release(SessionId id);
    /// The driver did something.
    void touch(SessionId id, double now);
    /// True: something changed, since the driver did not answer, or did nothing.
    bool tick(double now);

    std::optional<SessionId> driver() const { return driver_; }
    bool drives(SessionId id) const { return driver_ == id; }
    const std::vector<Person>& people() const { return people_; }
    std::vector<SessionId> asking() const;

  private:
    struct Asking {
        SessionId id;
        double since;
    };
    const Person* find(SessionId id) const;
    void makeDriver(SessionId id, double now);

    std::vector<Person> people_;
    std::vector<Asking> asking_; ///< in their order
    std::optional<SessionId> driver_;
    double lastTouch_ = 0;
};

} // namespace bridge
