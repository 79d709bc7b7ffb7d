/// A socket, HTTP and WebSocket by hand, so that tests can be as wrong as they like.
#pragma once

#include <nlohmann/json.hpp>

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace test {

using Bytes = std::vector<std::uint8_t>;
using namespace std::chrono_literals;

/// A TCP connection to 127.0.0.1, or to a Unix socket.
class RawSocket {
  public:
    explicit RawSocket(int port);
    explicit RawSocket(const std::string& path);
    /// Takes over a stream socket that is connected.
    static RawSocket ofDescriptor(int descriptor);
    ~RawSocket();
    RawSocket(RawSocket&& other) noexcept;
    RawSocket& operator=(RawSocket&& other) noexcept;

    bool write(std::string_view bytes) const; ///< false: it is closed
    void endWriting() const;                  ///< the other side reads to the end, and may still answer
    /// The bytes that come within the time; "" and closed() when the other side has ended the connection.
    std::string read(std::chrono::milliseconds within);
    bool closed() const { return closed_; }
    /// All until it is closed.
    std::string readAll(std::chrono::milliseconds within);

  private:
    RawSocket() = default;
    int socket_ = -1;
    bool closed_ = false;
};

struct WebFrame {
    int opcode = 0; ///< 1 text, 2 binary, 8 close, 9 ping, 10 pong
    std::string payload;
    int closeCode() const {
        return opcode == 8 && payload.size() >= 2
                   ? static_cast<std::uint8_t>(payload[0]) << 8 | static_cast<std::uint8_t>(payload[1])
                   : 0;
    }
};

/// One masked frame; `first` is its first byte (0x81: a whole text).
std::string webFrame(int first, std::string_view payload, bool masked = true,
                     std::optional<std::uint64_t> saidLength = {});

struct FrameHeader {
    int type = 0, codec = 0, flags = 0, width = 0, height = 0, shownWidth = 0, shownHeight = 0;
    std::uint32_t stream = 0, input = 0, age = 0, offset = 0, total = 0;
    std::uint64_t number = 0;
};
FrameHeader headerOf(std::string_view message);

class WebClient {
  public:
    /// Shakes hands; `status()` is the answer's.
    explicit WebClient(int port, const std::string& origin = "", const std::string& path = "/ws");
    WebClient(RawSocket socket, const std::string& host, const std::string& origin,
              const std::string& path = "/ws");
    int status() const { return status_; }

    bool hello(const std::string& token, const std::string& name = "test",
               nlohmann::json more = nlohmann::json::object());
    bool sendText(const std::string& text) { return socket_.write(webFrame(0x81, text)); }
    bool sendBinary(const Bytes& bytes) {
        return socket_.write(webFrame(0x82, {reinterpret_cast<const char*>(bytes.data()), bytes.size()}));
    }
    RawSocket& socket() { return socket_; }

    /// The next frame of whatever kind; pings are answered meanwhile unless told. Nothing: closed, or out of
    /// time.
    std::optional<WebFrame> next(std::chrono::milliseconds within = 5s);
    /// The next event of that name; frames on the way are acknowledged. Null: none came.
    nlohmann::json event(const std::string& name, std::chrono::milliseconds within = 5s);
    /// The answer to a request, which is sent.
    nlohmann::json request(nlohmann::json content, std::chrono::milliseconds within = 5s);
    /// The next message of that binary type; frames on the way are acknowledged, itself not.
    std::optional<WebFrame> binary(int type, std::chrono::milliseconds within = 5s);
    /// The close code that comes; 0: closed without one; -1: still open.
    int closeCode(std::chrono::milliseconds within = 5s);
    void acknowledge(const WebFrame& frame, int decodeTenthMs = 10);
    void input(const Bytes& held, int right = 0, int up = 0, const Bytes& taps = {});
    bool answersPings = true;

  private:
    void shakeHands(const std::string& host, const std::string& origin, const std::string& path);
    std::optional<WebFrame> parse();

    RawSocket socket_;
    std::string buffer_;
    int status_ = 0;
    std::uint32_t sequence_ = 0, lastRequest_ = 0;
};

} // namespace test
