// Frames that are wrong by RFC 6455, and those that are odd but right.
#include "process/bridge/bridge_fixture.h"

namespace {

using namespace test;

class Rfc6455 : public BridgeTest {};

std::string closeWith(int code, std::string_view reason = "") {
    return std::string{static_cast<char>(code >> 8), static_cast<char>(code)} + std::string(reason);
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
        {"opcode 7", webFrame(0x87, ""), 1002},
        {"opcode 11", webFrame(0x8B, ""), 1002},
        {"opcode 15", webFrame(0x8F, ""), 1002},
        {"unmasked text", webFrame(0x81, "{}", false), 1002},
        {"unmasked ping", webFrame(0x89, "", false), 1002},
        {"unmasked close", webFrame(0x88, "", false), 1002},
        {"fragmented ping", webFrame(0x09, "a"), 1002},
        {"fragmented close", webFrame(0x08, ""), 1002},
        {"long ping", webFrame(0x89, std::string(126, 'x')), 1002},
        {"long close", webFrame(0x88, closeWith(1000, std::string(124, 'x'))), 1002},
        {"continuation of nothing", webFrame(0x80, "a"), 1002},
        {"text inside a text", webFrame(0x01, "{") + webFrame(0x81, "}"), 1002},
        {"binary inside a text", webFrame(0x01, "{") + webFrame(0x82, "}"), 1002},
        {"close of one byte", webFrame(0x88, "\x03"), 1002},
        {"close code 0", webFrame(0x88, closeWith(0)), 1002},
        {"close code 999", webFrame(0x88, closeWith(999)), 1002},
        {"close code 1004", webFrame(0x88, closeWith(1004)), 1002},
        {"close code 1005", webFrame(0x88, closeWith(1005)), 1002},
        {"close code 1006", webFrame(0x88, closeWith(1006)), 1002},
        {"close reason of bad UTF-8", webFrame(0x88, closeWith(1000, "\xC0\xAF")), 1002},
        {"bad UTF-8", webFrame(0x81, "\xC0\xAF"), 1007},
        {"surrogate", webFrame(0x81, "\xED\xA0\x80"), 1007},
        {"unfinished UTF-8", webFrame(0x81, "\xE2\x82"), 1007},
        {"UTF-8 beyond", webFrame(0x81, "\xF4\x90\x80\x80"), 1007},
        {"bad UTF-8 in the second part", webFrame(0x01, "{") + webFrame(0x80, "\xFF"), 1007},
        {"4097 bytes", webFrame(0x82, std::string(4097, 'x')), 1009},
        {"a length of 2 GB", webFrame(0x82, "", true, 1ULL << 31), 1009},
        {"a length of 2^62", webFrame(0x82, "", true, 1ULL << 62), 1009},
        {"parts of 4097 bytes", webFrame(0x02, std::string(4000, 'x')) + webFrame(0x80, std::string(97, 'x')),
         1009},
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
}

} // namespace
