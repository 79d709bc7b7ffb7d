#include "bridge/visitor.h"

#include "bridge/control/plain_name.h"
#include "bridge/room/room.h"
#include "bridge/stream/wire.h"

#include <fmt/core.h>

#include <utility>

namespace bridge {

namespace {

using nlohmann::json;

constexpr double kHelloTime = 5;

std::string textOf(const json& message, const char* key) {
    const auto found = message.find(key);
    return found != message.end() && found->is_string() ? found->get<std::string>() : std::string();
}

PageView viewOf(const json& message) {
    PageView view;
    const auto found = message.find("view");
    if (found == message.end() || !found->is_object()) return view;
    const auto side = [&](const char* key) {
        constexpr double kMax = 32767;
        const auto value = found->find(key);
        if (value == found->end() || !value->is_number()) return 0;
        const auto pixels = value->get<double>();
        return pixels >= 1 && pixels <= kMax ? static_cast<int>(pixels) : 0;
    };
    view.width = side("w");
    view.height = side("h");
    return view;
}

} // namespace

void Visitor::text(std::string_view message) {
    room_ == nullptr ? hello(message) : room_->text(id_, message);
}

void Visitor::binary(std::span<const std::uint8_t> message) {
    if (room_ == nullptr) return close(CloseCode::BadMessage, "hello comes first");
    room_->binary(id_, message);
}

void Visitor::close(CloseCode code, const std::string& reason) {
    if (const auto outlet = outlet_.lock()) outlet->close(code, reason);
}

void Visitor::hello(std::string_view text) {
    const std::shared_ptr<Outlet> outlet = outlet_.lock();
    if (!outlet) return;
    constexpr int kDepth = 8;
    const auto shallow = [](int depth, json::parse_event_t, json&) { return depth < kDepth; };
    const json message = json::parse(text, shallow, false);
    if (!message.is_object() || textOf(message, "do") != "hello")
        return close(CloseCode::BadMessage, "hello comes first");
    const auto version = message.find("v");
    if (version == message.end() || !version->is_number_integer() || *version != kPageVersion)
        return close(CloseCode::OtherVersion, fmt::format("this bridge speaks version {}", kPageVersion));
    const std::string token = textOf(message, "token");
    const Right right = reception_.rightOf(token);
    if (right == Right::Used) {
        reception_.refused("used", address_);
        return close(CloseCode::UsedLink,
                     "this driver's link was used before; it is good once, for one page");
    }
    if (right == Right::None) {
        reception_.refused("token", address_);
        return close(CloseCode::BadToken, "the token is wrong; open the link that the bridge printed last");
    }
    Room* const room = reception_.room(textOf(message, "instance"));
    if (room == nullptr) return close(CloseCode::NoInstance, reception_.instanceList());
    Reception::Entrance entrance = reception_.enter(*room, token, right);
    room_ = room;
    id_ = entrance.id;
    own_ = std::move(entrance.own);
    const std::string name = plainName(textOf(message, "name"));
    const bool mayDrive = right == Right::Drive;
    person_ = fmt::format("{}: {} {}{}", room->instance(), mayDrive ? "driver" : "viewer", id_,
                          name.empty() ? "" : ", " + name + ",");
    reception_.note(fmt::format("{} came from {}", person_, address_));
    room->join({id_, name, mayDrive, viewOf(message), outlet, std::move(entrance.welcome)});
}

void Visitor::ponged(double seconds) {
    if (room_ != nullptr) room_->ponged(id_, seconds);
}

void Visitor::writable() {
    if (room_ != nullptr) room_->writable(id_);
}

void Visitor::leaves() { leaveRoom(true); }

void Visitor::leaveRoom(bool inOrder) {
    if (room_ == nullptr) return;
    std::exchange(room_, nullptr)->leave(id_);
    reception_.left(own_, inOrder);
    reception_.note(fmt::format("{} left after {:.0f} s", person_, clock_.seconds() - began_));
}

void Visitor::closed() {
    isClosed_ = true;
    leaveRoom(false);
    reception_.closed();
}

void Visitor::drop() {
    if (const auto outlet = outlet_.lock()) outlet->drop();
}

void Visitor::tick() {
    if (isNewcomer() && clock_.seconds() - began_ > kHelloTime)
        close(CloseCode::NoHello, "no hello within 5 s");
}

} // namespace bridge
