// The files of the page over the wire: packed or plain, and not again when the browser has them.
#include "process/bridge/bridge_fixture.h"

#include <libdeflate.h>

namespace {

using namespace test;

struct Answer {
    std::string head, body;
    int status() const { return head.size() > 12 ? std::atoi(head.c_str() + 9) : 0; }
    /// "" without that header.
    std::string header(const std::string& name) const {
        const std::size_t at = head.find("\r\n" + name + ": ");
        if (at == std::string::npos) return {};
        const std::size_t from = at + name.size() + 4;
        return head.substr(from, head.find("\r\n", from) - from);
    }
};

std::string unpacked(const std::string& packed, std::size_t size) {
    std::string plain(size, '\0');
    libdeflate_decompressor* const machine = libdeflate_alloc_decompressor();
    const auto result = libdeflate_gzip_decompress(machine, packed.data(), packed.size(), plain.data(),
                                                   plain.size(), nullptr);
    libdeflate_free_decompressor(machine);
    return result == LIBDEFLATE_SUCCESS ? plain : "broken";
}

class PageOverTheWire : public BridgeTest {
  protected:
    Answer ask(const std::string& path, const std::string& more = "") {
        const std::string whole = page(path, more);
        const std::size_t end = whole.find("\r\n\r\n");
        if (end == std::string::npos) return {whole, {}};
        return {whole.substr(0, end + 2), whole.substr(end + 4)};
    }
};

constexpr const char* kFiles[] = {"/", "/page.css", "/js/main.js", "/js/stream_worker.js", "/js/texts_cs.js"};

TEST_F(PageOverTheWire, IsPackedForThoseWhoTakeIt) {
    std::size_t all = 0;
    for (const char* const path : kFiles) {
        SCOPED_TRACE(path);
        const Answer plain = ask(path), packed = ask(path, "Accept-Encoding: gzip, deflate, br\r\n");
        EXPECT_EQ(plain.status(), 200);
        EXPECT_EQ(packed.status(), 200);
        EXPECT_EQ(plain.header("Content-Encoding"), "");
        EXPECT_EQ(packed.header("Content-Encoding"), "gzip");
        EXPECT_EQ(plain.header("Vary"), "Accept-Encoding");
        EXPECT_EQ(packed.header("Vary"), "Accept-Encoding");
        EXPECT_EQ(packed.header("Content-Type"), plain.header("Content-Type"));
        EXPECT_EQ(packed.header("Content-Length"), std::to_string(packed.body.size()));
        EXPECT_LT(packed.body.size(), plain.body.size());
        EXPECT_EQ(unpacked(packed.body, plain.body.size()), plain.body);
        all += packed.head.size() + packed.body.size();
    }
    EXPECT_LT(all, 100'000U);
}

TEST_F(PageOverTheWire, IsNotSentAgain) {
    const std::string gzip = "Accept-Encoding: gzip\r\n";
    for (const char* const path : kFiles) {
        SCOPED_TRACE(path);
        const std::string plain = ask(path).header("ETag"), packed = ask(path, gzip).header("ETag");
        EXPECT_NE(plain, packed);
        const auto known = [](const std::string& tag) { return "If-None-Match: " + tag + "\r\n"; };
        const Answer again = ask(path, gzip + known(packed));
        EXPECT_EQ(again.status(), 304);
        EXPECT_EQ(again.body, "");
        EXPECT_EQ(again.header("ETag"), packed);
        EXPECT_EQ(again.header("Vary"), "Accept-Encoding");
        EXPECT_EQ(ask(path, known(plain)).status(), 304);
        EXPECT_EQ(ask(path, known("\"other\", W/" + plain)).status(), 304);
        EXPECT_EQ(ask(path, known(packed)).status(), 200) << "that one was packed";
        EXPECT_EQ(ask(path, gzip + known(plain)).status(), 200) << "that one was plain";
    }
}

TEST_F(PageOverTheWire, TellsItsLengthWithoutABody) {
    const std::string whole = get("HEAD /js/main.js HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(port) +
                                  "\r\nConnection: close\r\nAccept-Encoding: gzip\r\n\r\n");
    const std::string packed = ask("/js/main.js", "Accept-Encoding: gzip\r\n").header("Content-Length");
    EXPECT_TRUE(whole.ends_with("\r\n\r\n"));
    EXPECT_NE(whole.find("Content-Length: " + packed + "\r\n"), std::string::npos);
}

} // namespace
