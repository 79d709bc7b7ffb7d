// The form in which a request gets a file of the page: packed or plain, or nothing since the browser has it.
#include "bridge/net/page_choice.h"
#include "bridge/net/page_files.h"

#include <gtest/gtest.h>

#include <set>

namespace {

using bridge::namesTag;
using bridge::takesGzip;

TEST(PageChoice, PacksForThoseWhoSaySo) {
    for (const char* const header : {"gzip", "gzip, deflate, br", "br;q=1.0, GZIP;q=0.5", "x-gzip", "*",
                                     "br, *;q=0.1", "identity;q=0, gzip ; q=0.001", "deflate,gzip"})
        EXPECT_TRUE(takesGzip(header)) << header;
    for (const char* const header : {"", "identity", "br", "gzip;q=0", "gzip;Q=0.000", "*;q=0", "gzip;q=0, *",
                                     "gzipped", ",,;", ";q=1", "br;gzip"})
        EXPECT_FALSE(takesGzip(header)) << header;
}

TEST(PageChoice, KnowsTheTagsThatABrowserHas) {
    for (const char* const header : {"\"ab\"", "W/\"ab\"", "*", "\"x\", \"ab\"", " \"ab\" ,"})
        EXPECT_TRUE(namesTag(header, "\"ab\"")) << header;
    for (const char* const header : {"", "ab", "\"a\"", "\"ab", "\"abc\"", "\"x\", \"y\"", ","})
        EXPECT_FALSE(namesTag(header, "\"ab\"")) << header;
}

// A body that is kept under a tag is never taken for another one.
TEST(PageChoice, EachBodyHasATagOfItsOwn) {
    std::set<std::string_view> tags;
    std::size_t bodies = 0;
    for (const bridge::PageFile& file : bridge::pageFiles()) {
        for (const bridge::PageBody& body : {file.plain, file.packed}) {
            ++bodies;
            tags.insert(body.tag);
            EXPECT_FALSE(body.bytes.empty()) << file.path;
        }
        EXPECT_TRUE(file.packed.bytes.starts_with("\x1f\x8b")) << file.path;
    }
    EXPECT_EQ(tags.size(), bodies);
    EXPECT_EQ(bridge::pageFiles().front().path, "/index.html");
}

} // namespace
