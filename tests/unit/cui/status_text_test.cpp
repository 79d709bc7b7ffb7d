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

TEST(StatusText, KeepsTheDigitsOfFloats) {
    ipc::Status status;
    status.exposure = 0.1F;
    status.fieldOfView = std::numeric_limits<float>::quiet_NaN();
    status.eye[0] = 1e-7F;
    status.eye[1] = -16777216;
    const std::string text = cui::statusJson("cow", 7, status);
    EXPECT_NE(text.find("\"exposure\":0.1,"), std::string::npos) << text;
    EXPECT_NE(text.find("\"fieldOfView\":null,"), std::string::npos) << text;
    EXPECT_NE(text.find("\"eye\":[1e-07,-16777216.0,0.0],"), std::string::npos) << text;
    EXPECT_EQ(text.find("{\"instance\":\"cow\",\"process\":7,\"state\":\"loading\",\"width\":0,"), 0U)
        << text;
    EXPECT_NE(cui::statusText("cow", 7, status).find("eye: 1e-07 -16777216 0\n"), std::string::npos);
}

TEST(StatusText, HasTheWidthOfAViewWithoutPerspective) {
    ipc::Status status;
    status.parallelWidth = 20.5F;
    EXPECT_NE(cui::statusJson("cow", 7, status).find("\"orthographicWidth\":20.5,"), std::string::npos);
    const std::string text = cui::statusText("cow", 7, status);
    EXPECT_NE(text.find("width of view: 20.5 of the scene, without perspective\n"), std::string::npos)
        << text;
    EXPECT_EQ(text.find("field of view"), std::string::npos);
}

TEST(StatusText, SaysWhatTheServerDoes) {
    ipc::Status status;
    EXPECT_NE(cui::statusText("cow", 7, status).find("state: loading\n"), std::string::npos);
    status.progress = 1;
    EXPECT_NE(cui::statusText("cow", 7, status).find("state: drawing\n"), std::string::npos);
    status.idle = 1;
    EXPECT_NE(cui::statusText("cow", 7, status).find("state: complete\n"), std::string::npos);
    status.paused = 1;
    EXPECT_NE(cui::statusText("cow", 7, status).find("state: paused\n"), std::string::npos);
}

TEST(StatusText, SaysHowManyPixelsAreNewWhereOthersAreKept) {
    ipc::Status status;
    EXPECT_EQ(cui::statusText("cow", 7, status).find("new pixels"), std::string::npos);
    EXPECT_NE(cui::statusJson("cow", 7, status).find("\"kept\":0.0,"), std::string::npos);
    status.kept = 0.979F;
    EXPECT_NE(cui::statusText("cow", 7, status).find("new pixels: 2.1 %\n"), std::string::npos);
    EXPECT_NE(cui::statusJson("cow", 7, status).find("\"kept\":0.979,"), std::string::npos);
}

TEST(StatusText, SaysHowSureIndirectLightIsWhereThereIsAny) {
    ipc::Status status;
    EXPECT_EQ(cui::statusText("cow", 7, status).find("indirect light"), std::string::npos);
    EXPECT_NE(cui::statusJson("cow", 7, status).find("\"indirectError\":0.0,"), std::string::npos);
    status.lightError = 0.034F;
    EXPECT_NE(cui::statusText("cow", 7, status).find("indirect light: +-3.4 %\n"), std::string::npos);
    EXPECT_NE(cui::statusJson("cow", 7, status).find("\"indirectError\":0.034,"), std::string::npos);
}

TEST(StatusText, SaysWhatAWholeFrameTakesWhileLiveOnesAreShown) {
    ipc::Status status;
    EXPECT_EQ(cui::statusText("cow", 7, status).find("whole frame"), std::string::npos) << "none yet";
    status.frameSeconds = 0.03;
    status.wholeSeconds = 31.5;
    EXPECT_NE(cui::statusText("cow", 7, status).find("whole frame: 31.50 s\n"), std::string::npos);
    EXPECT_NE(cui::statusJson("cow", 7, status).find("\"wholeSeconds\":31.5,"), std::string::npos);
}

TEST(ListText, NamesLivingAndDead) {
    const std::vector<ipc::Instance> instances{{"cow", true, 12, {}}, {"nave", false, 0, {}}};
    EXPECT_EQ(cui::listText(instances), "cow  process 12\nnave  dead; 'CUI free' removes it\n");
    EXPECT_EQ(cui::listJson(instances), "[{\"instance\":\"cow\",\"running\":true,\"process\":12},"
                                        "{\"instance\":\"nave\",\"running\":false,\"process\":0}]\n");
    EXPECT_EQ(cui::listJson({}), "[]\n");
}

} // namespace
