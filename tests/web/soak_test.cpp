// A page that walks for RT_BRIDGE_SOAK seconds: what it holds does not grow.
#include "web/bridged_server.h"

#include <cstdlib>

namespace {

using test::WebPage;

class PageSoak : public test::BridgedServer {
  protected:
    struct PageHoldings {
        double heapBytes = 0, nodes = 0, listeners = 0;
    };
    static PageHoldings holdingsOf(const WebPage& page) {
        page.call("HeapProfiler.collectGarbage");
        const test::Json counters = page.call("Memory.getDOMCounters");
        return {page.call("Runtime.getHeapUsage")["usedSize"].get<double>(), counters["nodes"].get<double>(),
                counters["jsEventListeners"].get<double>()};
    }
};

TEST_F(PageSoak, THOROUGH_LeavesThePageAsItWas) {
    const char* const asked = std::getenv("RT_BRIDGE_SOAK");
    const std::chrono::seconds time(asked == nullptr ? 6 : std::atoi(asked));
    const WebPage page = drive();
    ask("fly");
    capture(page);
    std::vector<PageHoldings> samples;
    for (int i = 0; i < 6; ++i) {
        page.keyDown(i % 2 == 0 ? "KeyW" : "KeyS");
        std::this_thread::sleep_for(time / 6.0);
        page.keyUp(i % 2 == 0 ? "KeyW" : "KeyS");
        samples.push_back(holdingsOf(page));
    }
    const PageHoldings &warm = samples[1], &last = samples.back();
    std::printf("%.1f MB at a third, %.1f MB at the end, %.0f nodes, %.0f listeners\n", warm.heapBytes / 1e6,
                last.heapBytes / 1e6, last.nodes, last.listeners);
    EXPECT_LT(last.heapBytes, warm.heapBytes + 2e6);
    EXPECT_LE(last.nodes, warm.nodes + 50);
    EXPECT_LE(last.listeners, warm.listeners + 10);
    EXPECT_TRUE(page.complaints().empty()) << testing::PrintToString(page.complaints());
}

} // namespace
