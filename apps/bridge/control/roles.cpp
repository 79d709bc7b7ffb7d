#include "bridge/control/roles.h"

#include <algorithm>
#include <utility>

namespace bridge {

namespace {

constexpr double kIdleDriver = 30, kAnswerTime = 10; // seconds

} // namespace

const Person* Roles::find(SessionId id) const {
    const auto found = std::ranges::find(people_, id, &Person::id);
    return found == people_.end() ? nullptr : &*found;
}

void Roles::makeDriver(SessionId id, double now) {
    driver_ = id;
    lastTouch_ = now;
    std::erase_if(asking_, [&](const Asking& each) { return each.id == id; });
    for (Asking& each : asking_) each.since = now; // they ask the new one
}

void Roles::join(Person person, double now) {
    const SessionId id = person.id;
    const bool drives = person.mayDrive && !driver_;
    people_.push_back(std::move(person));
    if (drives) makeDriver(id, now);
}

void Roles::leave(SessionId id) {
    std::erase_if(people_, [&](const Person& each) { return each.id == id; });
    std::erase_if(asking_, [&](const Asking& each) { return each.id == id; });
    if (driver_ == id) release(id);
}

void Roles::rename(SessionId id, std::string name) {
    const auto found = std::ranges::find(people_, id, &Person::id);
    if (found != people_.end()) found->name = std::move(name);
}

Roles::Asked Roles::ask(SessionId id, double now) {
    const Person* const person = find(id);
    if (person == nullptr || !person->mayDrive) return Asked::NotAllowed;
    if (driver_ == id) return Asked::Drives;
    if (!driver_ || now - lastTouch_ >= kIdleDriver) {
        makeDriver(id, now);
        return Asked::Drives;
    }
    if (std::ranges::find(asking_, id, &Asking::id) == asking_.end()) asking_.push_back({id, now});
    return Asked::Waits;
}

bool Roles::give(SessionId from, SessionId to, double now) {
    const Person* const person = find(to);
    if (driver_ != from || person == nullptr || !person->mayDrive) return false;
    makeDriver(to, now);
    return true;
}

bool Roles::keep(SessionId id) {
    if (driver_ != id) return false;
    asking_.clear();
    return true;
}

/// To the first who asks, else there is no driver.
bool Roles::release(SessionId id) {
    if (driver_ != id) return false;
    driver_.reset();
    if (!asking_.empty()) makeDriver(asking_.front().id, asking_.front().since);
    return true;
}

void Roles::touch(SessionId id, double now) {
    if (driver_ == id) lastTouch_ = now;
}

bool Roles::tick(double now) {
    if (asking_.empty()) return false;
    if (driver_ && now - asking_.front().since < kAnswerTime && now - lastTouch_ < kIdleDriver) return false;
    makeDriver(asking_.front().id, now);
    return true;
}

std::vector<SessionId> Roles::asking() const {
    std::vector<SessionId> ids;
    for (const Asking& each : asking_) ids.push_back(each.id);
    return ids;
}

} // namespace bridge
