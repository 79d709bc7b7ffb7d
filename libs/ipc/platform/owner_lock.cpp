#include "ipc/platform/owner_lock.h"

#include "ipc/platform/boost_interprocess.h"
#include "ipc/platform/error.h"

#include <boost/interprocess/sync/file_lock.hpp>

#include <map>
#include <mutex>

namespace ipc {

namespace {

// A process drops its lock by closing any descriptor of the file, so it never opens a file that it holds.
struct Held {
    struct Entry {
        std::int64_t process; ///< a fork inherits the table, not the locks
        FileIdentity identity;
        friend bool operator==(const Entry&, const Entry&) = default;
    };
    std::mutex mutex;
    std::map<std::string, Entry> byPath;

    // A removed file is held, but is of no use to anybody.
    bool holds(const std::string& path) const {
        const auto entry = byPath.find(path);
        return entry != byPath.end() && entry->second == Entry{processId(), identityOf(path)};
    }
};

Held& held() {
    static Held table;
    return table;
}

} // namespace

struct OwnerLock::State {
    std::string path;
    boost::interprocess::file_lock lock;
    FileIdentity identity;
};

OwnerLock::OwnerLock(std::unique_ptr<State> state) : state_(std::move(state)) {}
OwnerLock::OwnerLock(OwnerLock&&) noexcept = default;

OwnerLock& OwnerLock::operator=(OwnerLock&& other) noexcept {
    std::swap(state_, other.state_);
    return *this;
}

OwnerLock::~OwnerLock() {
    if (!state_) return;
    const std::lock_guard guard(held().mutex);
    const auto entry = held().byPath.find(state_->path);
    const Held::Entry own{processId(), state_->identity};
    if (entry != held().byPath.end() && entry->second == own) held().byPath.erase(entry);
    state_.reset();
}

std::optional<OwnerLock> OwnerLock::tryTake(const std::string& path) {
    const std::lock_guard guard(held().mutex);
    if (held().holds(path)) return std::nullopt;
    try {
        createPrivateFile(path);
        auto state = std::make_unique<State>(State{path, boost::interprocess::file_lock(path.c_str()), {}});
        if (!state->lock.try_lock()) return std::nullopt;
        state->identity = identityOf(path);
        held().byPath[path] = {processId(), state->identity};
        return OwnerLock(std::move(state));
    } catch (const boost::interprocess::interprocess_exception& error) {
        throw Error(Problem::System, path + ": cannot be locked: " + error.what());
    }
}

bool OwnerLock::stands() const { return state_->identity == identityOf(state_->path); }

LockHolder lockHolder(const std::string& path) {
    const std::lock_guard guard(held().mutex);
    return held().holds(path) ? LockHolder{true, processId()} : foreignLockHolder(path);
}

} // namespace ipc
