// Frames that are wrong by RFC 6455, and those that are odd but right.
#include "process/bridge/bridge_fixture.h"

namespace {

using namespace test;

class Rfc6455 : public BridgeTest {};

std::string closeWith(int code, std::string_view reason = "") {
    return std::string{static_cast<char>(code >> 8), static_cast<char>(code)} + std::string(reason);
}

/// A text or ping whose length is told in 2 (`form` 126) or 8 bytes (127), however short it is.
std::string withLength(int first, int form, std::string_view payload) {
    std::string bytes{static_cast<char>(first), static_cast<char>(0x80 | form)};
    for (int shift = form == 126 ? 8 : 56; shift >= 0; shift -= 8)
        bytes += static_cast<char>(static_cast<std::uint64_t>(payload.size()) >> shift);
    return bytes + std::string(4, '\0') + std::string(payload); // by a mask of zeros
}

TEST_F(Rfc6455, WrongFramesAreClosedWithTheirCode) {
    const struct {
        const char* what;
        std::string bytes;
        int code;
    } rows[] = {
        {"reserved bit 1", webFrame(0xC1, "{}"), 1002},
        {"reserved bit 2", webFrame(0xA1, "{}"), 1002},
        {"reserved bit 3", webFrame(0x91, "{}"), 1002},
        {"opcode 3", webFrame(0x83, ""), 1002},
        {"opcode 4", webFrame(0x84, ""), 1002},
        {"opcode 5", webFrame(0x85, "{}"), 1002},
        {"opcode 6", webFrame(0x86, ""), 1002},
        {"opcode 7", webFrame(0x87, ""), 1002},
        {"opcode 11", webFrame(0x8B, ""), 1002},
        {"opcode 12", webFrame(0x8C, ""), 1002},
        {"opcode 13", webFrame(0x8D, "x"), 1002},
        {"opcode 14", webFrame(0x8E, ""), 1002},
        {"opcode 15", webFrame(0x8F, ""), 1002},
        {"all reserved bits", webFrame(0xF1, "{}"), 1002},
        {"a ping with a reserved bit", webFrame(0xC9, ""), 1002},
        {"a close with a reserved bit", webFrame(0xC8, ""), 1002},
        {"unmasked binary", webFrame(0x82, "x", false), 1002},
        {"unmasked pong", webFrame(0x8A, "", false), 1002},
        {"unmasked text", webFrame(0x81, "{}", false), 1002},
        {"unmasked ping", webFrame(0x89, "", false), 1002},
        {"unmasked close", webFrame(0x88, "", false), 1002},
        {"fragmented ping", webFrame(0x09, "a"), 1002},
        {"fragmented close", webFrame(0x08, ""), 1002},
        {"fragmented pong", webFrame(0x0A, ""), 1002},
        {"long pong", webFrame(0x8A, std::string(126, 'x')), 1002},
        {"a ping in a length of 16 bits", withLength(0x89, 126, "x"), 1002},
        {"5 bytes in a length of 16 bits", withLength(0x81, 126, "hello"), 1002},
        {"5 bytes in a length of 64 bits", withLength(0x81, 127, "hello"), 1002},
        {"300 bytes in a length of 64 bits", withLength(0x81, 127, std::string(300, 'x')), 1002},
        {"a length of 2^63", webFrame(0x82, "", true, 1ULL << 63), 1009},
        {"long ping", webFrame(0x89, std::string(126, 'x')), 1002},
        {"long close", webFrame(0x88, closeWith(1000, std::string(124, 'x'))), 1002},
        {"last part of nothing", webFrame(0x80, "a"), 1002},
        {"a part of nothing", webFrame(0x00, "a"), 1002},
        {"a part after the last one",
         webFrame(0x01, R"({"id":1,)") + webFrame(0x80, R"("do":"ask"})") + webFrame(0x80, ""), 1002},
        {"text inside a text", webFrame(0x01, "{") + webFrame(0x81, "}"), 1002},
        {"binary inside a text", webFrame(0x01, "{") + webFrame(0x82, "}"), 1002},
        {"close of one byte", webFrame(0x88, "\x03"), 1002},
        {"close code 0", webFrame(0x88, closeWith(0)), 1002},
        {"close code 999", webFrame(0x88, closeWith(999)), 1002},
        {"close code 1004", webFrame(0x88, closeWith(1004)), 1002},
        {"close code 1005", webFrame(0x88, closeWith(1005)), 1002},
        {"close code 1006", webFrame(0x88, closeWith(1006)), 1002},
        {"close code 1014", webFrame(0x88, closeWith(1014)), 1002},
        {"close code 1015", webFrame(0x88, closeWith(1015)), 1002},
        {"close code 1016", webFrame(0x88, closeWith(1016)), 1002},
        {"close code 2999", webFrame(0x88, closeWith(2999)), 1002},
        {"close reason of bad UTF-8", webFrame(0x88, closeWith(1000, "\xC0\xAF")), 1002},
        {"bad UTF-8", webFrame(0x81, "\xC0\xAF"), 1007},
        {"surrogate", webFrame(0x81, "\xED\xA0\x80"), 1007},
        {"bad UTF-8 over two parts", webFrame(0x01, "\xF4") + webFrame(0x80, "\x90\x80\x80"), 1007},
        {"unfinished UTF-8", webFrame(0x81, "\xE2\x82"), 1007},
        {"UTF-8 beyond", webFrame(0x81, "\xF4\x90\x80\x80"), 1007},
        {"bad UTF-8 in the second part", webFrame(0x01, "{") + webFrame(0x80, "\xFF"), 1007},
        {"8193 bytes", webFrame(0x82, std::string(8193, 'x')), 1009},
        {"a length of 2 GB", webFrame(0x82, "", true, 1ULL << 31), 1009},
        {"a length of 2^62", webFrame(0x82, "", true, 1ULL << 62), 1009},
        {"parts of 8193 bytes",
         webFrame(0x02, std::string(8000, 'x')) + webFrame(0x80, std::string(193, 'x')), 1009},
    };
    for (const auto& row : rows) {
        const auto client = join(kViewer);
        client->socket().write(row.bytes);
        const int code = client->closeCode();
        EXPECT_TRUE(code == row.code || (row.code == 1002 && code == 0)) << row.what << ": " << code;
    }
}

TEST_F(Rfc6455, WhatIsOddButRightIsServed) {
    const std::string request = R"({"id":7,"do":"walk"})";
    const struct {
        const char* what;
        std::string bytes;
    } rows[] = {
        {"one byte a part",
         [&] {
             std::string parts;
             for (std::size_t i = 0; i < request.size(); ++i)
                 parts +=
                     webFrame((i == 0 ? 1 : 0) | (i + 1 == request.size() ? 0x80 : 0), request.substr(i, 1));
             return parts;
         }()},
        {"a ping between the parts",
         webFrame(0x01, request.substr(0, 5)) + webFrame(0x89, "hi") + webFrame(0x80, request.substr(5))},
        {"empty parts", webFrame(0x01, "") + webFrame(0x00, request) + webFrame(0x80, "")},
        {"a pong that nobody asked for", webFrame(0x8A, "x") + webFrame(0x81, request)},
    };
    for (const auto& row : rows) {
        const auto client = join();
        client->socket().write(row.bytes);
        EXPECT_EQ(client->event("answer")["id"], 7) << row.what;
        client->sendText(R"({"id":8,"do":"release"})");
        client->event("answer");
    }
}

TEST_F(Rfc6455, PingsAndClosesAreAnswered) {
    const auto client = join();
    client->socket().write(webFrame(0x89, "are you there"));
    std::optional<WebFrame> frame;
    do frame = client->next(2s);
    while (frame && frame->opcode != 10);
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->payload, "are you there");
    client->socket().write(webFrame(0x88, closeWith(1000, "bye")));
    EXPECT_EQ(client->closeCode(), 1000);
    for (const int code : {1001, 1003, 1011, 3000, 4999}) {
        const auto other = join(kViewer);
        other->socket().write(webFrame(0x88, closeWith(code)));
        EXPECT_EQ(other->closeCode(), code);
    }
}

TEST_F(Rfc6455, NothingIsDoneAfterAClose) {
    const auto client = join();
    ASSERT_EQ(client->request({{"do", "walk"}})["ok"], true);
    const auto before = server->commands();
    client->socket().write(webFrame(0x88, closeWith(1000)) + webFrame(0x81, R"({"id":7,"do":"fly"})"));
    EXPECT_EQ(client->closeCode(), 1000);
    // Its connection is still open. The next one drives, so all that the first sent was taken.
    EXPECT_EQ(join()->request({{"do", "pause"}})["ok"], true);
    auto expected = before;
    expected.push_back("pause");
    EXPECT_EQ(server->commands(), expected);
}

} // namespace
