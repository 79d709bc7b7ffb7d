#include "ipc/platform/segment.h"

#include "ipc/platform/boost_interprocess.h"
#include "ipc/platform/error.h"
#include "ipc/platform/stage.h"
#include "ipc/platform/system.h"

#include <boost/interprocess/mapped_region.hpp>
#include <boost/interprocess/shared_memory_object.hpp>

namespace ipc {

namespace bi = boost::interprocess;

struct Segment::State {
    bi::shared_memory_object memory;
    bi::mapped_region map;
};

namespace {

[[noreturn]] void notYours(const std::string& name, const std::string& why) {
    throw Error(Problem::NotYours, "shared memory " + name + ": " + why);
}

} // namespace

Segment::Segment(std::unique_ptr<State> state) : state_(std::move(state)) {}
Segment::Segment(Segment&&) noexcept = default;
Segment& Segment::operator=(Segment&&) noexcept = default;
Segment::~Segment() = default;

Segment Segment::create(const std::string& name, std::size_t bytes) {
    try {
        auto state = std::make_unique<State>();
        state->memory =
            bi::shared_memory_object(bi::create_only, name.c_str(), bi::read_write, bi::permissions(0600));
        try {
            stage("segment made");
            reserveSpace(state->memory.get_mapping_handle().handle, bytes, name);
            stage("segment reserved");
            state->map = bi::mapped_region(state->memory, bi::read_write, 0, bytes);
        } catch (...) {
            remove(name);
            throw;
        }
        return Segment(std::move(state));
    } catch (const bi::interprocess_exception& error) {
        if (error.get_error_code() == bi::already_exists_error)
            notYours(name, "the name is taken and cannot be removed");
        throw Error(Problem::System, "shared memory " + name + ": " + error.what());
    }
}

std::optional<Segment> Segment::open(const std::string& name, Access access, std::size_t atLeast) {
    const bi::mode_t mode = access == Access::Read ? bi::read_only : bi::read_write;
    try {
        auto state = std::make_unique<State>();
        state->memory = bi::shared_memory_object(bi::open_only, name.c_str(), mode);
        const SegmentFacts facts = factsOf(state->memory.get_mapping_handle().handle);
        if (!facts.regular) notYours(name, "is not a segment");
        if (!facts.ours) notYours(name, "belongs to another user or is open to others; remove it");
        if (facts.bytes < atLeast) return std::nullopt;
        state->map = bi::mapped_region(state->memory, mode, 0, facts.bytes);
        return Segment(std::move(state));
    } catch (const bi::interprocess_exception& error) {
        const bi::error_code_t code = error.get_error_code();
        if (code == bi::not_found_error) return std::nullopt;
        if (code == bi::out_of_resource_error || code == bi::out_of_memory_error) {
            throw Error(Problem::System, "shared memory " + name + ": " + error.what());
        }
        notYours(name, error.what()); // no permission, a link, a folder
    }
}

void Segment::reserve(const std::string& name) {
    try {
        const bi::shared_memory_object memory(bi::open_only, name.c_str(), bi::read_write);
        const int handle = memory.get_mapping_handle().handle;
        reserveSpace(handle, factsOf(handle).bytes, name);
    } catch (const bi::interprocess_exception& error) {
        throw Error(Problem::System, "shared memory " + name + ": " + error.what());
    }
}

void Segment::remove(const std::string& name) noexcept { bi::shared_memory_object::remove(name.c_str()); }

void* Segment::data() const { return state_->map.get_address(); }
std::size_t Segment::bytes() const { return state_->map.get_size(); }
bool Segment::named() const { return factsOf(state_->memory.get_mapping_handle().handle).named; }

} // namespace ipc
