// The same over TLS.
#include "bridge/net/http_connection-inl.h"

#include "rtcore/platform/error.h"

#include <boost/asio/ssl/context.hpp>
#include <boost/asio/ssl/stream.hpp>
#include <boost/beast/websocket/ssl.hpp>

#include <filesystem>

namespace bridge {

namespace {

namespace ssl = boost::asio::ssl;
using TlsStream = ssl::stream<StreamSocket>;

class OpenDoor : public TlsDoor {
  public:
    explicit OpenDoor(const TlsFiles& files) : context_(ssl::context::tls_server) {
        for (const std::string& file : {files.certificate, files.key}) {
            std::error_code unknown;
            if (!std::filesystem::exists(file, unknown))
                throw rtcore::FileError(rtcore::FailureKind::NoInput, file, "there is no such file");
        }
        ErrorCode error;
        context_.set_options(ssl::context::default_workarounds | ssl::context::no_sslv2 |
                             ssl::context::no_sslv3 | ssl::context::no_tlsv1 | ssl::context::no_tlsv1_1);
        context_.use_certificate_chain_file(files.certificate, error);
        if (error) fail(files.certificate, "this is no certificate in PEM: " + error.message());
        context_.use_private_key_file(files.key, ssl::context::pem, error);
        if (error) fail(files.key, "this is no key in PEM of that certificate: " + error.message());
    }
    void serve(StreamSocket socket, const std::string& address, HttpShared& shared) override {
        std::make_shared<HttpConnection<TlsStream>>(TlsStream(std::move(socket), context_), address, shared)
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
