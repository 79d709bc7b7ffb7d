#include "ipc/platform/segment.h"

#include "ipc/platform/boost_interprocess.h"
#include "ipc/platform/error.h"
#include "ipc/platform/fault_point.h"
#include "ipc/platform/rules.h"
#include "ipc/platform/system.h"

#include <boost/interprocess/mapped_region.hpp>
#include <boost/interprocess/shared_memory_object.hpp>

namespace ipc {

namespace bi = boost::interprocess;

struct Segment::State {
    ~State() {
        if (opened >= 0) closeSegment(opened);
    }
    int descriptor() const { return opened >= 0 ? opened : made.get_mapping_handle().handle; }
    // Boost's map asks a segment for it. Segments of others are not opened by Boost, which would wait for the
    // other end of a pipe.
    bi::mapping_handle_t get_mapping_handle() const { return {descriptor(), false}; }
    void fill(const std::string& name, std::size_t bytes) {
        try {
            faultPoint("segment made");
            if (bytes == 0) return;
            reserveSpace(descriptor(), bytes, name);
            faultPoint("segment reserved");
            map = bi::mapped_region(*this, bi::read_write, 0, bytes);
        } catch (...) {
            remove(name);
            throw;
        }
    }

    bi::shared_memory_object made;
    int opened = -1;
    bi::mapped_region map;
};

namespace {

[[noreturn]] void failed(const std::string& name, const bi::interprocess_exception& error) {
    throw Error(Problem::System, "shared memory {0}: {1}", {name, error.what()});
}

} // namespace

Segment::Segment(std::unique_ptr<State> state) : state_(std::move(state)) {}
Segment::Segment(Segment&&) noexcept = default;
Segment& Segment::operator=(Segment&&) noexcept = default;
Segment::~Segment() = default;

// Nothing when the name is taken.
std::unique_ptr<Segment::State> Segment::make(const std::string& name) {
    try {
        auto state = std::make_unique<State>();
        state->made =
            bi::shared_memory_object(bi::create_only, name.c_str(), bi::read_write, bi::permissions(0600));
        return state;
    } catch (const bi::interprocess_exception& error) {
        if (error.get_error_code() == bi::already_exists_error) return nullptr;
        failed(name, error);
    }
}

Segment Segment::create(const std::string& name, std::size_t bytes) {
    std::unique_ptr<State> state = make(name);
    if (!state) {
        throw Error(Problem::NotYours,
                    "shared memory {0}: the name is taken; remove it or name another instance", {name});
    }
    state->fill(name, bytes);
    return Segment(std::move(state));
}

std::optional<Segment> Segment::createLocked(const std::string& name, std::size_t bytes, std::uint64_t byte) {
    std::unique_ptr<State> state = make(name);
    if (!state) return std::nullopt;
    faultPoint("segment unlocked");
    // From now on the name stays: only the holder of the lock may remove it.
    if (!tryLockByte(state->descriptor(), byte) || !factsOf(state->descriptor()).named) return std::nullopt;
    state->fill(name, bytes);
    return Segment(std::move(state));
}

std::optional<Segment> Segment::open(const std::string& name, Access access, std::size_t atLeast) {
    auto state = std::make_unique<State>();
    state->opened = openSegment(name, access == Access::Write);
    if (state->opened < 0) return std::nullopt;
    const SegmentFacts facts = factsOf(state->opened);
    if (!facts.regular) {
        throw Error(Problem::NotYours,
                    "shared memory {0}: is not a segment; remove it or name another instance", {name});
    }
    if (!facts.ours && keeps("segments are ours alone")) {
        throw Error(Problem::NotYours,
                    "shared memory {0}: belongs to another user or is open to others; remove it or name "
                    "another instance",
                    {name});
    }
    if (facts.bytes < atLeast) return std::nullopt;
    try {
        const bi::mode_t mode = access == Access::Read ? bi::read_only : bi::read_write;
        if (facts.bytes > 0) state->map = bi::mapped_region(*state, mode, 0, facts.bytes);
    } catch (const bi::interprocess_exception& error) {
        failed(name, error);
    }
    return Segment(std::move(state));
}

void Segment::reserve(const std::string& name) {
    const std::optional<Segment> segment = open(name, Access::Write, 0);
    if (segment) reserveSpace(segment->state_->descriptor(), segment->bytes(), name);
}

void Segment::remove(const std::string& name) noexcept { bi::shared_memory_object::remove(name.c_str()); }

void* Segment::data() const { return state_->map.get_address(); }
std::size_t Segment::bytes() const { return state_->map.get_size(); }
bool Segment::named() const { return factsOf(state_->descriptor()).named; }
bool Segment::tryLock(std::uint64_t byte) const { return tryLockByte(state_->descriptor(), byte); }
void Segment::unlock(std::uint64_t byte) const { unlockByte(state_->descriptor(), byte); }
bool Segment::locked(std::uint64_t byte) const { return isByteLocked(state_->descriptor(), byte); }

} // namespace ipc
