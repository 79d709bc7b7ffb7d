// Heads of requests that are damaged at random: each is answered or refused, and honest pages do not notice.
#include "process/bridge/bridge_fixture.h"
#include "support/damaged_text.h"

#include <algorithm>
#include <array>

namespace {

using namespace test;

constexpr std::array<std::string_view, 20> kHttpTokens{"\r\n",
                                                       "\n",
                                                       "\r",
                                                       "\r\n\r\n",
                                                       ":",
                                                       " ",
                                                       "\t",
                                                       "HTTP/1.1",
                                                       "HTTP/1.0",
                                                       "HTTP/2.0",
                                                       "GET ",
                                                       "POST ",
                                                       "Transfer-Encoding: chunked\r\n",
                                                       "Content-Length: 18446744073709551616\r\n",
                                                       "Content-Length: -1\r\n",
                                                       "Expect: 100-continue\r\n",
                                                       "/../../etc/passwd",
                                                       "%00",
                                                       "\xFF",
                                                       "Upgrade: h2c\r\n"};

/// Every second connection of the first so many stays open after its head.
constexpr long kOpenHeads = 1'000;

class DamagedHeads : public BridgeTest {};

TEST_F(DamagedHeads, HarmNobody) {
    const std::string own = "127.0.0.1:" + std::to_string(port);
    const std::string host = " HTTP/1.1\r\nHost: " + own + "\r\n";
    DamagedText damaged({"GET /" + host + "\r\n", "GET /status" + host + "Accept: */*\r\n\r\n",
                         "GET /ws" + host + "Origin: http://" + own +
                             "\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
                             "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n"},
                        kHttpTokens, 12);
    const auto honest = join();
    std::array<long, 6> answers{}; // by the first digit of the status; 0: none
    long faults = 0;
    for (long i = 0; i < damagedTexts(); ++i) {
        RawSocket socket(port);
        socket.write(damaged.next() + "\r\n\r\n");
        // Who waits for a body that never comes takes the whole time, so most say that there is none.
        if (i % 2 == 0 || i >= kOpenHeads) socket.endWriting();
        const std::string answer = socket.read(200ms);
        ASSERT_TRUE(answer.empty() || answer.starts_with("HTTP/1.1 ")) << answer;
        ++answers.at(answer.empty() ? 0 : static_cast<std::size_t>(answer.at(9) - '0'));
        if (answer.starts_with("HTTP/1.1 500")) ++faults;
        if (i % 100 != 0) continue;
        ASSERT_FALSE(honest->request({{"do", "walk"}}, 10s).is_null()) << "after head " << i;
    }
    EXPECT_GT(answers[1] + answers[2], 0) << "some damage does not matter";
    EXPECT_GT(answers[4], 0) << "some does";
    EXPECT_EQ(faults, 0);
    EXPECT_TRUE(eventually([&] { return WebClient(port).status() == 101; }, 20s)) << "others are let in";
}

} // namespace
