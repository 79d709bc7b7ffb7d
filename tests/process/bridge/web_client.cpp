#include "process/bridge/web_client.h"

#include <fmt/core.h>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

namespace test {

namespace {

using SteadyClock = std::chrono::steady_clock;

std::chrono::milliseconds leftUntil(SteadyClock::time_point end) {
    return std::max(0ms, std::chrono::duration_cast<std::chrono::milliseconds>(end - SteadyClock::now()));
}

std::uint64_t number(std::string_view bytes, std::size_t at, int size) {
    std::uint64_t value = 0;
    for (int i = size - 1; i >= 0; --i)
        value = value << 8 | static_cast<std::uint8_t>(bytes[at + static_cast<std::size_t>(i)]);
    return value;
}

void append(Bytes& bytes, std::uint64_t value, int size) {
    for (int i = 0; i < size; ++i) bytes.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
}

} // namespace

RawSocket::RawSocket(int port) : socket_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    closed_ = ::connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0;
    const int on = 1; // as browsers do
    ::setsockopt(socket_, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
}

RawSocket::RawSocket(const std::string& path) : socket_(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::copy_n(path.c_str(), std::min(path.size() + 1, sizeof address.sun_path), address.sun_path);
    closed_ = ::connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0;
}

RawSocket RawSocket::ofDescriptor(int descriptor) {
    RawSocket socket;
    socket.socket_ = descriptor;
    return socket;
}

RawSocket::~RawSocket() {
    if (socket_ >= 0) ::close(socket_);
}
RawSocket::RawSocket(RawSocket&& other) noexcept
    : socket_(std::exchange(other.socket_, -1)), closed_(other.closed_) {}
RawSocket& RawSocket::operator=(RawSocket&& other) noexcept {
    std::swap(socket_, other.socket_);
    std::swap(closed_, other.closed_);
    return *this;
}

void RawSocket::endWriting() const { ::shutdown(socket_, SHUT_WR); }
bool RawSocket::write(std::string_view bytes) const {
    while (!bytes.empty()) {
        const ssize_t count = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
        if (count <= 0) return false;
        bytes.remove_prefix(static_cast<std::size_t>(count));
    }
    return true;
}

std::string RawSocket::read(std::chrono::milliseconds within) {
    pollfd event{socket_, POLLIN, 0};
    if (closed_ || ::poll(&event, 1, static_cast<int>(within.count())) <= 0) return {};
    std::string bytes(65536, '\0');
    const ssize_t count = ::recv(socket_, bytes.data(), bytes.size(), 0);
    closed_ = count <= 0;
    bytes.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
    return bytes;
}

std::string RawSocket::readAll(std::chrono::milliseconds within) {
    const auto end = SteadyClock::now() + within;
    std::string all;
    while (!closed_ && SteadyClock::now() < end) all += read(leftUntil(end));
    return all;
}

std::string webFrame(int first, std::string_view payload, bool masked,
                     std::optional<std::uint64_t> saidLength) {
    const std::uint64_t length = saidLength.value_or(payload.size());
    std::string frame(1, static_cast<char>(first));
    const int mask = masked ? 0x80 : 0;
    constexpr int kShort = 125;
    if (length <= kShort) {
        frame += static_cast<char>(mask | static_cast<int>(length));
    } else if (length < 65536) {
        frame += static_cast<char>(mask | 126);
        frame += static_cast<char>(length >> 8);
        frame += static_cast<char>(length);
    } else {
        frame += static_cast<char>(mask | 127);
        for (int shift = 56; shift >= 0; shift -= 8) frame += static_cast<char>(length >> shift);
    }
    const std::array<char, 4> key{0x11, 0x22, 0x33, 0x44};
    if (masked) frame.append(key.data(), key.size());
    for (std::size_t i = 0; i < payload.size(); ++i)
        frame += static_cast<char>(payload[i] ^ (masked ? key[i % 4] : 0));
    return frame;
}

FrameHeader headerOf(std::string_view m) {
    if (m.size() < 40) throw std::runtime_error("a binary message without a header");
    FrameHeader h;
    h.type = static_cast<int>(number(m, 0, 1));
    h.codec = static_cast<int>(number(m, 1, 1));
    h.flags = static_cast<int>(number(m, 2, 2));
    h.stream = static_cast<std::uint32_t>(number(m, 4, 4));
    h.number = number(m, 8, 8);
    h.width = static_cast<int>(number(m, 16, 2));
    h.height = static_cast<int>(number(m, 18, 2));
    h.shownWidth = static_cast<int>(number(m, 20, 2));
    h.shownHeight = static_cast<int>(number(m, 22, 2));
    h.input = static_cast<std::uint32_t>(number(m, 24, 4));
    h.age = static_cast<std::uint32_t>(number(m, 28, 4));
    h.offset = static_cast<std::uint32_t>(number(m, 32, 4));
    h.total = static_cast<std::uint32_t>(number(m, 36, 4));
    return h;
}

WebClient::WebClient(int port, const std::string& origin, const std::string& path) : socket_(port) {
    const std::string host = fmt::format("127.0.0.1:{}", port);
    shakeHands(host, origin.empty() ? "http://" + host : origin, path);
}

WebClient::WebClient(RawSocket socket, const std::string& host, const std::string& origin,
                     const std::string& path)
    : socket_(std::move(socket)) {
    shakeHands(host, origin, path);
}

void WebClient::shakeHands(const std::string& host, const std::string& origin, const std::string& path) {
    socket_.write(fmt::format(
        "GET {} HTTP/1.1\r\nHost: {}\r\n{}Upgrade: websocket\r\nConnection: Upgrade\r\n"
        "Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n"
        "Sec-WebSocket-Protocol: rtbridge.1\r\nSec-WebSocket-Extensions: permessage-deflate\r\n\r\n",
        path, host, origin == "-" ? "" : "Origin: " + origin + "\r\n"));
    const auto end = SteadyClock::now() + 5s;
    while (buffer_.find("\r\n\r\n") == std::string::npos && !socket_.closed() && SteadyClock::now() < end)
        buffer_ += socket_.read(leftUntil(end));
    const std::size_t head = buffer_.find("\r\n\r\n");
    if (head == std::string::npos) return;
    status_ = std::stoi(buffer_.substr(9, 3));
    if (buffer_.find("permessage-deflate") < head) status_ = -1; // compression was declined, or it is wrong
    buffer_.erase(0, head + 4);
}

bool WebClient::hello(const std::string& token, const std::string& name, nlohmann::json more) {
    more["do"] = "hello";
    if (!more.contains("v")) more["v"] = 2;
    more["token"] = token;
    more["name"] = name;
    return sendText(more.dump());
}

std::optional<WebFrame> WebClient::parse() {
    if (buffer_.size() < 2) return {};
    std::size_t start = 2;
    std::uint64_t length = static_cast<std::uint8_t>(buffer_[1]) & 127U;
    const std::size_t more = length == 126 ? 2 : length == 127 ? 8 : 0;
    if (buffer_.size() < start + more) return {};
    if (more > 0) length = 0;
    for (std::size_t i = 0; i < more; ++i)
        length = length << 8 | static_cast<std::uint8_t>(buffer_[start + i]);
    start += more;
    if (buffer_.size() < start + length) return {};
    WebFrame frame{static_cast<std::uint8_t>(buffer_[0]) & 15, buffer_.substr(start, length)};
    buffer_.erase(0, start + length);
    return frame;
}

std::optional<WebFrame> WebClient::next(std::chrono::milliseconds within) {
    const auto end = SteadyClock::now() + within;
    for (;;) {
        while (const auto frame = parse()) {
            if (frame->opcode != 9) return frame;
            if (answersPings) socket_.write(webFrame(0x8A, frame->payload));
        }
        if (socket_.closed()) return {};
        const std::string more = socket_.read(leftUntil(end));
        if (more.empty() && SteadyClock::now() >= end) return {};
        buffer_ += more;
    }
}

nlohmann::json WebClient::event(const std::string& name, std::chrono::milliseconds within) {
    const auto end = SteadyClock::now() + within;
    while (const auto frame = next(leftUntil(end))) {
        if (frame->opcode == 2) acknowledge(*frame);
        if (frame->opcode != 1) continue;
        nlohmann::json content = nlohmann::json::parse(frame->payload);
        if (content["event"] == name) return content;
    }
    return {};
}

nlohmann::json WebClient::request(nlohmann::json content, std::chrono::milliseconds within) {
    const std::uint32_t id = ++lastRequest_;
    content["id"] = id;
    sendText(content.dump());
    for (;;) {
        nlohmann::json answer = event("answer", within);
        if (answer.is_null() || answer["id"] == id) return answer;
    }
}

std::optional<WebFrame> WebClient::binary(int type, std::chrono::milliseconds within) {
    const auto end = SteadyClock::now() + within;
    while (const auto frame = next(leftUntil(end))) {
        if (frame->opcode != 2) continue;
        if (headerOf(frame->payload).type == type) return frame;
        acknowledge(*frame);
    }
    return {};
}

int WebClient::closeCode(std::chrono::milliseconds within) {
    const auto end = SteadyClock::now() + within;
    while (const auto frame = next(leftUntil(end)))
        if (frame->opcode == 8) return frame->closeCode();
    return socket_.closed() ? 0 : -1;
}

void WebClient::acknowledge(const WebFrame& frame, int decodeTenthMs) {
    const FrameHeader header = headerOf(frame.payload);
    if (header.type != 1 && header.type != 2) return;
    Bytes ack{static_cast<std::uint8_t>(header.type == 1 ? 1 : 4), 0};
    append(ack, static_cast<std::uint64_t>(decodeTenthMs), 2);
    append(ack, header.stream, 4);
    append(ack, header.number, 8);
    sendBinary(ack);
}

void WebClient::input(const Bytes& held, int right, int up, const Bytes& taps) {
    Bytes message{2, static_cast<std::uint8_t>(held.size()), static_cast<std::uint8_t>(taps.size()), 0};
    append(message, ++sequence_, 4);
    append(message, static_cast<std::uint32_t>(right), 4);
    append(message, static_cast<std::uint32_t>(up), 4);
    message.insert(message.end(), held.begin(), held.end());
    message.insert(message.end(), taps.begin(), taps.end());
    sendBinary(message);
}

} // namespace test
