/// One connection: requests for pages, and the WebSocket that one of them may become. A template over plain
/// and TLS streams, included by one source for each, since Beast takes half a minute to compile.
#pragma once

#include "bridge/clock.h"
#include "bridge/control/caps.h"
#include "bridge/net/http_state.h"
#include "bridge/net/page_choice.h"
#include "bridge/net/page_files.h"
#include "bridge/net/receiving_limit.h"

#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core/basic_stream.hpp>
#include <boost/beast/core/buffers_to_string.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>

#include <array>
#include <chrono>
#include <deque>
#include <optional>
#include <variant>

namespace bridge {

namespace http = boost::beast::http;
namespace websocket = boost::beast::websocket;
namespace asio = boost::asio;
using ErrorCode = boost::system::error_code;
using namespace std::chrono_literals;

constexpr auto kRequestTime = 10s, kSilence = 30s, kClosing = 5s, kEnding = 1s;
constexpr std::size_t kMaxMessage = kMaxPageMessage, kMaxHeader = 8192, kMaxQueued = 4U << 20;
constexpr double kMessageRate = 250, kMessageBurst = 500;
constexpr const char* kSubprotocol = "rtbridge.1";

/// The bytes of so many messages of the largest size, and of their headers. Of one message that comes in
/// parts of a byte, each in a record of TLS, a quarter is its own.
constexpr double kMaxBytes = kMaxMessage + 128;
constexpr std::size_t kMaxUnfinished = 64 * kMaxMessage;

using CountedSocket =
    boost::beast::basic_stream<asio::generic::stream_protocol, asio::any_io_executor, ReceivingLimit>;
inline CountedSocket counted(StreamSocket socket) {
    return {ReceivingLimit(kMessageRate * kMaxBytes, kMessageBurst * kMaxBytes, kMaxUnfinished),
            std::move(socket)};
}

/// Adds the headers of every answer: no foreign content, no framing, no caching without revalidation.
template <typename Message>
void addHeaders(Message& message) {
    message.set(http::field::server, "RTBridge");
    message.set("Content-Security-Policy", "default-src 'none'; script-src 'self'; worker-src 'self'; "
                                           "style-src 'self'; img-src 'self' blob: data:; "
                                           "connect-src 'self'; manifest-src 'self'; base-uri 'none'; "
                                           "form-action 'none'; frame-ancestors 'none'");
    message.set("X-Content-Type-Options", "nosniff");
    message.set("Referrer-Policy", "no-referrer");
    message.set("Cross-Origin-Opener-Policy", "same-origin");
    message.set("Cross-Origin-Resource-Policy", "same-origin");
    message.set("X-Frame-Options", "DENY");
    message.set(http::field::cache_control, "no-cache");
}

inline std::string_view view(boost::beast::string_view text) { return {text.data(), text.size()}; }

const char* typeOfPath(std::string_view path);

/// A WebSocket that is open.
template <typename Stream>
class WebSession : public Outlet, public std::enable_shared_from_this<WebSession<Stream>> {
  public:
    WebSession(Stream stream, std::string address, HttpShared& shared)
        : socket_(std::in_place, std::move(stream)), deadline_(socket_->get_executor()),
          address_(std::move(address)), shared_(shared), bucket_(kMessageRate, kMessageBurst) {
        websocket::stream_base::timeout times{};
        times.handshake_timeout = kRequestTime;
        times.idle_timeout = kSilence;
        times.keep_alive_pings = true;
        socket_->set_option(times);
        socket_->set_option(websocket::stream_base::decorator([](websocket::response_type& response) {
            response.set(http::field::server, "RTBridge");
            response.set(http::field::sec_websocket_protocol, kSubprotocol);
        }));
        socket_->read_message_max(kMaxMessage);
        socket_->auto_fragment(false);
    }

    template <typename Request>
    void accept(const Request& request) {
        socket_->async_accept(request, [self = this->shared_from_this()](ErrorCode error) {
            if (!error) self->opened();
        });
    }

    void sendText(std::string text) override { enqueue({std::move(text), {}, {}, false}); }
    void sendBinary(const Header& header, const Shipment* shipment) override {
        enqueue({{}, header, shipment != nullptr ? *shipment : Shipment{}, true});
    }
    bool busy() const override { return writing_ || !queue_.empty() || closing_; }
    void ping() override {
        if (closing_ || pinging_) return;
        pinging_ = true;
        pinged_ = nowSeconds();
        socket_->async_ping({}, [self = this->shared_from_this()](ErrorCode) { self->pinging_ = false; });
    }
    void close(CloseCode code, const std::string& reason) override {
        if (closing_) return;
        closing_ = true;
        queue_.clear();
        constexpr std::size_t kMaxReason = 120;
        const websocket::close_reason why(static_cast<websocket::close_code>(code),
                                          reason.substr(0, kMaxReason).c_str());
        socket_->async_close(why, [self = this->shared_from_this()](ErrorCode) { self->tellClosed(); });
        abandonLater();
    }
    void drop() override {
        if (!receiver_) return;
        closing_ = true;
        queue_.clear();
        abandon();
    }
    const std::string& address() const override { return address_; }

  private:
    struct Item {
        std::string text;
        Header header{};
        Shipment shipment;
        bool binary;
        std::size_t size() const { return sizeof(Item) + text.size(); }
    };
    void enqueue(Item item) {
        if (closing_) return;
        queued_ += item.size();
        if (queued_ > kMaxQueued) return close(CloseCode::Silent, "messages are not read");
        queue_.push_back(std::move(item));
        writeNext();
    }

    ReceivingLimit& limit() { return boost::beast::get_lowest_layer(*socket_).rate_policy(); }
    void opened() {
        limit().watchMessages([weak = this->weak_from_this(), executor = socket_->get_executor()] {
            asio::post(executor, [weak] {
                if (const auto self = weak.lock()) self->close(CloseCode::Flood, "too many bytes");
            });
        });
        socket_->control_callback([this](websocket::frame_type type, boost::beast::string_view) {
            limit().messageCame();
            const bool asked = type == websocket::frame_type::pong && pinged_ > 0;
            if (asked) {
                const double rtt = nowSeconds() - std::exchange(pinged_, 0);
                if (receiver_) receiver_->ponged(rtt);
            }
            if (type == websocket::frame_type::close) return leave();
            if (!asked && !bucket_.take(nowSeconds())) close(CloseCode::Flood, "too many messages");
        });
        receiver_ = shared_.handlers.opened(this->shared_from_this());
        read();
    }

    void read() {
        socket_->async_read(buffer_, [self = this->shared_from_this()](ErrorCode error, std::size_t) {
            self->haveRead(error);
        });
    }
    void haveRead(ErrorCode error) {
        if (error) {
            closing_ = true;
            return tellClosed();
        }
        limit().messageCame();
        if (!bucket_.take(nowSeconds())) close(CloseCode::Flood, "too many messages");
        if (!closing_ && receiver_) {
            const auto data = buffer_.cdata();
            const auto* const bytes = static_cast<const std::uint8_t*>(data.data());
            if (socket_->got_text()) {
                receiver_->text({reinterpret_cast<const char*>(bytes), data.size()});
            } else {
                receiver_->binary({bytes, data.size()});
            }
        }
        buffer_.consume(buffer_.size());
        if (!closing_) read(); // else the close reads on
    }

    void writeNext() {
        if (writing_ || queue_.empty() || closing_) return;
        writing_ = true;
        current_.emplace(std::move(queue_.front()));
        queue_.pop_front();
        const bool text = !current_->binary;
        socket_->text(text);
        const auto done = [self = this->shared_from_this()](ErrorCode error, std::size_t) {
            self->wrote(error);
        };
        if (text) return socket_->async_write(asio::buffer(current_->text), done);
        const Shipment& shipment = current_->shipment;
        const std::uint8_t* const payload =
            shipment.frame ? shipment.frame->bytes.data() + shipment.offset : nullptr;
        const std::array<asio::const_buffer, 2> buffers{
            asio::buffer(current_->header), asio::const_buffer(payload, shipment.frame ? shipment.size : 0)};
        socket_->async_write(buffers, done);
    }
    void wrote(ErrorCode error) {
        writing_ = false;
        queued_ -= std::min(queued_, current_->size());
        current_.reset();
        if (error || closing_) return;
        writeNext();
        if (!busy() && receiver_) receiver_->writable();
    }

    /// A page that says so leaves the room at once, also where the connection stays for a while. Beast
    /// answers.
    void leave() {
        if (closing_) return;
        closing_ = true;
        queue_.clear();
        if (receiver_) receiver_->leaves();
        abandonLater();
    }
    void abandonLater() {
        deadline_.expires_after(kClosing);
        deadline_.async_wait([weak = this->weak_from_this()](ErrorCode error) {
            const auto self = weak.lock();
            if (!error && self) self->abandon();
        });
    }
    /// A read that meets a wrong message while a close is under way waits for it, and the close for the read
    /// (Boost 1.81): neither ends, and Beast's timeouts close the connection only. They go with the stream,
    /// once all others have ended with the connection.
    void abandon() {
        tellClosed();
        boost::beast::get_lowest_layer(*socket_).close();
        deadline_.expires_after(kEnding);
        deadline_.async_wait([self = this->shared_from_this()](ErrorCode) { self->socket_.reset(); });
    }
    void tellClosed() {
        if (const auto receiver = std::exchange(receiver_, nullptr)) receiver->closed();
    }

    std::optional<websocket::stream<Stream>> socket_; ///< nothing once it was abandoned
    asio::steady_timer deadline_;                     ///< of closing
    std::string address_;
    HttpShared& shared_;
    TokenBucket bucket_;
    boost::beast::flat_buffer buffer_;
    std::deque<Item> queue_;
    std::optional<Item> current_;
    std::size_t queued_ = 0;
    std::shared_ptr<Receiver> receiver_;
    double pinged_ = 0;
    bool writing_ = false, closing_ = false, pinging_ = false;
};

/// Requests over one connection, one after the other.
template <typename Stream>
class HttpConnection : public Pending, public std::enable_shared_from_this<HttpConnection<Stream>> {
  public:
    HttpConnection(Stream stream, std::string address, HttpShared& shared)
        : stream_(std::move(stream)), address_(std::move(address)), shared_(shared),
          timer_(stream_->get_executor()) {}
    ~HttpConnection() override { shared_.waiting.remove(this); }

    void start() {
        shared_.waiting.add(this->weak_from_this());
        setDeadline();
        if constexpr (requires { typename Stream::handshake_type; }) {
            stream_->async_handshake(Stream::server, [self = this->shared_from_this()](ErrorCode error) {
                if (!error) self->read();
            });
        } else {
            read();
        }
    }
    const std::string& address() const override { return address_; }
    void drop() override {
        if (stream_) boost::beast::get_lowest_layer(*stream_).close();
    }

  private:
    using Response = http::response<http::string_body>;

    void setDeadline() {
        timer_.expires_after(kRequestTime);
        timer_.async_wait([weak = this->weak_from_this()](ErrorCode error) {
            const auto self = weak.lock();
            if (!error && self) self->drop();
        });
    }
    void read() {
        parser_.emplace();
        parser_->header_limit(kMaxHeader);
        parser_->body_limit(0);
        http::async_read_header(
            *stream_, buffer_, *parser_,
            [self = this->shared_from_this()](ErrorCode error, std::size_t) { self->haveRead(error); });
    }
    void haveRead(ErrorCode error) {
        if (error == http::error::end_of_stream) return finish();
        if (error && error.category() == http::make_error_code(http::error::bad_target).category())
            return answer(status(http::status::bad_request, "this is no request\n"), false);
        if (error) return;
        try {
            respond(parser_->get());
        } catch (const std::exception&) {
            answer(status(http::status::internal_server_error, "the bridge failed\n"), false);
        }
    }

    static Response status(http::status code, std::string text) {
        Response response(code, 11);
        response.set(http::field::content_type, "text/plain; charset=utf-8");
        response.body() = std::move(text);
        return response;
    }
    Response refuse(http::status code, const char* reason, std::string text) {
        if (shared_.handlers.refused) shared_.handlers.refused(reason, address_);
        return status(code, std::move(text));
    }

    using Request = http::request<http::empty_body>;
    static std::string_view fieldOf(const Request& request, http::field name) { return view(request[name]); }
    static std::optional<std::string_view> originOf(const Request& request) {
        const auto found = request.find(http::field::origin);
        if (found == request.end()) return {};
        return view(found->value());
    }

    void respond(const Request& request) {
        const bool stays = request.keep_alive();
        // The bytes that follow may be the body of the refused request, not another request.
        if (std::optional<Response> refusal = refusalOf(request)) return answer(std::move(*refusal), false);
        std::string_view path = view(request.target()).substr(0, view(request.target()).find('?'));
        const std::string& prefix = shared_.names.prefix;
        if (!prefix.empty() && path.starts_with(prefix + "/")) path.remove_prefix(prefix.size());
        if (path == "/ws") return upgrade(request);
        for (const PageFile& file : pageFiles())
            if (file.path == path || (path == "/" && &file == pageFiles().data()))
                return answer(pageOf(file, request), stays);
        std::string_view bearer = fieldOf(request, http::field::authorization);
        bearer = bearer.starts_with("Bearer ") ? bearer.substr(7) : std::string_view();
        HttpAnswer made = shared_.handlers.answer(path, bearer, address_);
        Response response = status(static_cast<http::status>(made.status), std::move(made.body));
        response.set(http::field::content_type, made.type);
        answer(std::move(response), stays);
    }

    std::optional<Response> refusalOf(const Request& request) {
        if (request.count(http::field::host) != 1 || request.count(http::field::origin) > 1)
            return refuse(http::status::bad_request, "malformed", "one Host, and one Origin at most\n");
        if (request.version() != 11)
            return refuse(http::status::http_version_not_supported, "malformed", "HTTP/1.1 only\n");
        if (!isOurHost(shared_.names, fieldOf(request, http::field::host)))
            return refuse(http::status::misdirected_request, "host", "this bridge has another name\n");
        if (!view(request.target()).starts_with('/'))
            return refuse(http::status::bad_request, "malformed", "this is no path\n");
        if (request.method() != http::verb::get && request.method() != http::verb::head) {
            Response response = refuse(http::status::method_not_allowed, "method", "GET and HEAD only\n");
            response.set(http::field::allow, "GET, HEAD");
            return response;
        }
        if (request.count(http::field::transfer_encoding) + request.count(http::field::content_length) > 0)
            return refuse(http::status::bad_request, "malformed", "a request has no body here\n");
        return {};
    }

    static Response pageOf(const PageFile& file, const Request& request) {
        const bool packed = takesGzip(fieldOf(request, http::field::accept_encoding));
        const PageBody& body = packed ? file.packed : file.plain;
        Response response(http::status::ok, 11);
        if (namesTag(fieldOf(request, http::field::if_none_match), body.tag)) {
            response.result(http::status::not_modified);
        } else {
            response.body() = body.bytes;
            if (packed) response.set(http::field::content_encoding, "gzip");
        }
        response.set(http::field::content_type, typeOfPath(file.path));
        response.set(http::field::etag, body.tag);
        response.set(http::field::vary, "Accept-Encoding");
        return response;
    }

    void upgrade(const Request& request) {
        if (std::optional<Response> refusal = upgradeRefusal(request))
            return answer(std::move(*refusal), false);
        timer_.cancel();
        shared_.waiting.remove(this);
        const auto session = std::make_shared<WebSession<Stream>>(std::move(*stream_), address_, shared_);
        stream_.reset();
        session->accept(request);
    }
    std::optional<Response> upgradeRefusal(const Request& request) {
        if (!isOurOrigin(shared_.names, fieldOf(request, http::field::host), originOf(request)))
            return refuse(http::status::forbidden, "origin", "this page is not the bridge's\n");
        if (!websocket::is_upgrade(request)) {
            Response response =
                refuse(http::status::upgrade_required, "upgrade", "a WebSocket is expected here\n");
            response.set(http::field::upgrade, "websocket");
            return response;
        }
        http::token_list offered(request[http::field::sec_websocket_protocol]);
        if (!offered.exists(kSubprotocol))
            return refuse(http::status::bad_request, "protocol", "the protocol rtbridge.1 is expected\n");
        if (shared_.handlers.enters()) return {};
        return refuse(http::status::service_unavailable, "full",
                      "the bridge has as many viewers as it may\n");
    }

    void answer(Response response, bool stays) {
        addHeaders(response);
        response.keep_alive(stays);
        const bool head = parser_ && parser_->is_header_done() && parser_->get().method() == http::verb::head;
        if (response.result() != http::status::not_modified) response.prepare_payload();
        if (head) response.body().clear(); // its length stays told
        const auto sent = std::make_shared<Response>(std::move(response));
        http::async_write(*stream_, *sent,
                          [self = this->shared_from_this(), sent, stays](ErrorCode error, std::size_t) {
                              if (error) return;
                              if (!stays) return self->finish();
                              self->setDeadline();
                              self->read();
                          });
    }
    void finish() {
        ErrorCode ignored;
        boost::beast::get_lowest_layer(*stream_).socket().shutdown(asio::socket_base::shutdown_send, ignored);
    }

    std::optional<Stream> stream_;
    std::string address_;
    HttpShared& shared_;
    asio::steady_timer timer_;
    boost::beast::flat_buffer buffer_{kMaxHeader + 1024};
    std::optional<http::request_parser<http::empty_body>> parser_;
};

} // namespace bridge
