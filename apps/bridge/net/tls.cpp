// The same over TLS.
#include "bridge/net/http_connection-inl.h"

#include "rtcore/platform/error.h"
#include "rtcore/platform/files.h"

#include <boost/asio/ssl/context.hpp>
#include <boost/asio/ssl/stream.hpp>
#include <boost/beast/websocket/ssl.hpp>

#include <filesystem>

namespace bridge {

namespace {

namespace ssl = boost::asio::ssl;
using TlsStream = ssl::stream<CountedSocket>;

/// A pipe or a device would keep the start waiting.
std::string pemOf(const std::string& file) {
    constexpr std::size_t kMax = 1U << 20;
    std::error_code unknown;
    const auto status = std::filesystem::status(file, unknown);
    if (!std::filesystem::exists(status))
        throw rtcore::FileError(rtcore::FailureKind::NoInput, file, "there is no such file");
    if (!std::filesystem::is_regular_file(status))
        throw rtcore::FileError(rtcore::FailureKind::NoInput, file,
                                "it is no regular file; give a file in PEM");
    return rtcore::readTextFile(file, kMax);
}

class OpenDoor : public TlsDoor {
  public:
    explicit OpenDoor(const TlsFiles& files) : context_(ssl::context::tls_server) {
        const std::string certificate = pemOf(files.certificate), key = pemOf(files.key);
        bool encrypted = false;
        ErrorCode error;
        // Else OpenSSL asks at the terminal, which a service has not.
        context_.set_password_callback([&](std::size_t, ssl::context::password_purpose) {
            encrypted = true;
            return std::string();
        });
        context_.set_options(ssl::context::default_workarounds | ssl::context::no_sslv2 |
                             ssl::context::no_sslv3 | ssl::context::no_tlsv1 | ssl::context::no_tlsv1_1);
        context_.use_certificate_chain(asio::buffer(certificate), error);
        if (error) fail(files.certificate, "this is no certificate in PEM: " + error.message());
        context_.use_private_key(asio::buffer(key), ssl::context::pem, error);
        context_.set_password_callback(
            [](std::size_t, ssl::context::password_purpose) { return std::string(); });
        if (encrypted)
            fail(files.key,
                 "the key is encrypted, and a bridge asks for no password; write it without one by "
                 "'(umask 077; openssl pkey -in KEY -out FILE)'");
        if (error) fail(files.key, "this is no key in PEM of that certificate: " + error.message());
    }
    void serve(StreamSocket socket, const std::string& address, HttpShared& shared) override {
        std::make_shared<HttpConnection<TlsStream>>(TlsStream(counted(std::move(socket)), context_), address,
                                                    shared)
            ->start();
    }

  private:
    [[noreturn]] static void fail(const std::string& file, const std::string& why) {
        throw rtcore::FileError(rtcore::FailureKind::BadData, file, why);
    }
    ssl::context context_;
};

} // namespace

std::unique_ptr<TlsDoor> openTlsDoor(const TlsFiles& files) { return std::make_unique<OpenDoor>(files); }

} // namespace bridge
