/// Lights that clients edit, in a server of their own.
#include "process/server/live_server.h"

#include "common/commands/state_report.h"

#include "ipc/endpoint/client.h"

#include <gtest/gtest.h>

#include <random>
#include <string>

namespace {

using namespace test;

class EditedLights : public LiveServer {
  protected:
    void SetUp() override {
        LiveServer::SetUp();
        start();
    }
    std::string path(const std::string& name) const { return (folder() / name).string(); }
    std::string done(ipc::Client& client, const std::string& line) const {
        const ipc::Reply reply = client.request(line);
        EXPECT_EQ(reply.status, ipc::ReplyStatus::Done) << line << ": " << reply.text;
        return reply.text;
    }
    std::string picture(ipc::Client& client, const std::string& name) const {
        done(client, "wait-idle");
        done(client, "screenshot " + path(name));
        return bytes(name);
    }
};

TEST_F(EditedLights, AreTakenBackToTheSameBitsByAnotherClient) {
    ipc::Client one(instance.name()), other(instance.name());
    const std::string before = picture(one, "before.png");
    std::mt19937 random(4711);
    const auto some = [&](int max) { return std::to_string(static_cast<int>(random() % max) + 1); };
    std::string id = done(one, "light add point here");
    for (int i = 0; i < 60; ++i) {
        ipc::Client& client = i % 2 == 0 ? one : other;
        switch (random() % 8) {
        case 0:
            id = done(client, "light copy " + id + " at " + some(4) + " " + some(3) + " " + some(4));
            break;
        case 1:
            done(client, "light temperature " + id + " " + std::to_string(2000 + 10 * (random() % 800)));
            break;
        case 2:
            done(client, "light colour " + id + " " + some(9) + " " + some(9) + " " + some(9));
            break;
        case 3:
            done(client, "light kind " + id + (random() % 2 == 0 ? " rectangle" : " spot"));
            break;
        case 4:
            done(client, "light power " + id + " " + some(500));
            break;
        case 5:
            done(client, "light " + id + " toggle");
            break;
        case 6:
            done(client, "light name " + id + " bulb" + some(9));
            break;
        default:
            done(client, "also light move " + id + " at " + some(4) + " " + some(3) + " " + some(4));
        }
    }
    EXPECT_NE(picture(one, "edited.png"), before);
    while (app::parseStateReport(done(one, "state")).edits > 0) done(other, "undo");
    EXPECT_EQ(picture(one, "after.png"), before);
}

TEST_F(EditedLights, AnExportedSceneGivesThemBack) {
    ipc::Client client(instance.name());
    const std::string id = done(client, "light add rectangle at 0 2.5 1");
    for (const std::string edit : {"temperature ID 2700", "power ID 300", "aim ID along 0.2 -1 0.1",
                                   "size ID 0.7 0.3", "name ID \"a panel\""}) {
        std::string line = "light " + edit;
        line.replace(line.find("ID"), 2, id);
        done(client, line);
    }
    const std::string edited = picture(client, "edited.png"), said = done(client, "light get " + id);
    done(client, "export scene " + path("kept.scn"));
    done(client, "load scene " + path("kept.scn"));
    EXPECT_EQ(done(client, "light get " + id), said);
    EXPECT_EQ(picture(client, "again.png"), edited);
}

} // namespace
