#include "cui/status_text.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <limits>

namespace {

TEST(StatusText, IsJson) {
    ipc::Status status;
    status.width = 640;
    status.exposure = 0.1F;
    status.progress = 1;
    status.idle = 1;
    status.raysPerSecond = std::numeric_limits<double>::infinity();
    const std::string text = cui::statusJson("cow", 7, status);
    const nlohmann::json json = nlohmann::json::parse(text);
    EXPECT_EQ(json["instance"], "cow");
    EXPECT_EQ(json["process"], 7);
    EXPECT_EQ(json["state"], "idle");
    EXPECT_EQ(json["width"], 640);
    EXPECT_EQ(json["exposure"].get<float>(), 0.1F);
    EXPECT_TRUE(json["raysPerSecond"].is_null());
    EXPECT_EQ(text.find('\n'), text.size() - 1);
}

TEST(StatusText, SaysWhatTheServerDoes) {
    ipc::Status status;
    EXPECT_NE(cui::statusText("cow", 7, status).find("state: loading\n"), std::string::npos);
    status.progress = 1;
    EXPECT_NE(cui::statusText("cow", 7, status).find("state: drawing\n"), std::string::npos);
    status.idle = 1;
    EXPECT_NE(cui::statusText("cow", 7, status).find("state: idle\n"), std::string::npos);
    status.paused = 1;
    EXPECT_NE(cui::statusText("cow", 7, status).find("state: paused\n"), std::string::npos);
}

TEST(ListText, NamesLivingAndDead) {
    const std::vector<ipc::Instance> instances{{"cow", true, 12}, {"nave", false, 0}};
    EXPECT_EQ(cui::listText(instances), "cow  process 12\nnave  dead; 'CUI free' removes it\n");
    EXPECT_EQ(nlohmann::json::parse(cui::listJson(instances))[1]["running"], false);
    EXPECT_EQ(cui::listJson({}), "[]\n");
}

} // namespace
