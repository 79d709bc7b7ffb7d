// Commands and keys beside a real server in the same process.
#include "bridge/control/command_link.h"

#include "unit/bridge/served_instance.h"

#include <gtest/gtest.h>

#include <list>
#include <map>
#include <mutex>
#include <optional>

namespace {

using bridge::CommandLink;
using bridge::KeySet;
using bridge::ServerLink;

class LinkToAServer : public testing::Test {
  protected:
    using Lines = std::vector<std::string>;
    /// The events that its thread has reported so far.
    struct News {
        std::vector<ServerLink> servers;
        std::string why;
        std::vector<std::string> states, messages, bindings;
        std::optional<ipc::Status> status;
        std::map<std::string, ipc::Reply> replies; ///< by the command
    };
    bridge::ServerEvents events() {
        bridge::ServerEvents all;
        all.server = [this](ServerLink server, const rtcore::Sentence& why) {
            const std::lock_guard lock(mutex_);
            told_.servers.push_back(server);
            told_.why = why.english();
        };
        all.status = [this](const ipc::Status& status) {
            const std::lock_guard lock(mutex_);
            told_.status = status;
        };
        all.state = [this](std::string report) {
            const std::lock_guard lock(mutex_);
            told_.states.push_back(std::move(report));
        };
        all.messages = [this](std::string lines, const std::string&) {
            const std::lock_guard lock(mutex_);
            told_.messages.push_back(std::move(lines));
        };
        all.bindings = [this](std::string lines) {
            const std::lock_guard lock(mutex_);
            told_.bindings.push_back(std::move(lines));
        };
        return all;
    }
    void open(bool anyone = true, app::KeyRestraint restraint = app::KeyRestraint::None) {
        link = std::make_unique<CommandLink>(instance.name(), restraint, events());
        link->setAnyone(anyone);
    }
    News told() {
        const std::lock_guard lock(mutex_);
        return told_;
    }
    bool becomes(ServerLink server) {
        return instance.until([&] {
            const News news = told();
            return !news.servers.empty() && news.servers.back() == server;
        });
    }
    void request(const std::string& command) {
        link->request(command, [this, command](ipc::Reply reply) {
            const std::lock_guard lock(mutex_);
            told_.replies[command] = std::move(reply);
        });
    }
    bool isAnswered(const std::string& command) {
        return instance.until([&] { return told().replies.contains(command); });
    }

    test::ServedInstance instance;

  private:
    std::mutex mutex_;
    News told_;

  protected:
    std::unique_ptr<CommandLink> link; ///< last: its thread tells this
};

TEST_F(LinkToAServer, TellsServersThatComeAndGo) {
    open();
    EXPECT_TRUE(becomes(ServerLink::Gone));
    EXPECT_NE(told().why.find(instance.name()), std::string::npos) << told().why;
    instance.start();
    EXPECT_TRUE(becomes(ServerLink::There));
    EXPECT_NE(link->figures().epoch, 0U);
    instance.stop();
    EXPECT_TRUE(becomes(ServerLink::Gone));
    instance.start();
    EXPECT_TRUE(becomes(ServerLink::There));
    std::vector<ServerLink> servers = told().servers;
    std::erase(servers, ServerLink::Busy); // of a machine that is
    EXPECT_EQ(servers,
              (std::vector{ServerLink::Gone, ServerLink::There, ServerLink::Gone, ServerLink::There}));
}

TEST_F(LinkToAServer, LeavesTheSlotToOthersWithoutAnyone) {
    instance.start();
    open(false);
    EXPECT_TRUE(becomes(ServerLink::There));
    EXPECT_EQ(instance.server().clients(), 0);
    link->setAnyone(true);
    EXPECT_TRUE(instance.until([&] { return instance.server().clients() == 1; }));
    link->setAnyone(false);
    EXPECT_TRUE(instance.until([&] { return instance.server().clients() == 0; }));
}

TEST_F(LinkToAServer, TellsWhyItIsRefused) {
    instance.start();
    std::list<ipc::Client> others;
    for (std::size_t i = 0; i < ipc::kMaxClients; ++i) others.emplace_back(instance.name());
    open();
    EXPECT_TRUE(becomes(ServerLink::Refused));
    EXPECT_FALSE(told().why.empty());
    others.pop_front();
    EXPECT_TRUE(becomes(ServerLink::There));
}

TEST_F(LinkToAServer, BringsAnswers) {
    instance.start();
    instance.onCommand = [&](const ipc::Command& command) {
        if (command.text == "walk") instance.server().answer(command, "walks");
        if (command.text == "fly") instance.server().refuse(command, 3, "no wings");
        return command.text == "walk" || command.text == "fly";
    };
    open();
    request("walk");
    request("fly");
    ASSERT_TRUE(isAnswered("walk") && isAnswered("fly"));
    EXPECT_EQ(told().replies["walk"].status, ipc::ReplyStatus::Done);
    EXPECT_EQ(told().replies["walk"].text, "walks");
    EXPECT_EQ(told().replies["fly"].status, ipc::ReplyStatus::Failed);
    EXPECT_EQ(told().replies["fly"].text, "no wings");
    EXPECT_EQ(instance.commands, (Lines{"walk", "fly"})) << "in their order";
}

TEST_F(LinkToAServer, AnswersItselfWhereNoServerDoes) {
    open();
    request("walk");
    ASSERT_TRUE(isAnswered("walk"));
    EXPECT_EQ(told().replies["walk"].status, ipc::ReplyStatus::NotSent);
    instance.start();
    instance.onCommand = [&](const ipc::Command& command) { return command.text == "fly"; }; // never
    request("fly");
    ASSERT_TRUE(instance.until([&] { return !instance.commands.empty(); }));
    instance.stop();
    ASSERT_TRUE(isAnswered("fly"));
    EXPECT_NE(told().replies["fly"].status, ipc::ReplyStatus::Done);
}

TEST_F(LinkToAServer, AnswersWhatIsOpenWhenItEnds) {
    instance.start();
    instance.onCommand = [&](const ipc::Command& command) { return command.text == "walk"; }; // never
    open();
    request("walk");
    ASSERT_TRUE(instance.until([&] { return !instance.commands.empty(); }));
    link.reset();
    EXPECT_EQ(told().replies["walk"].status, ipc::ReplyStatus::NotSent);
}

TEST_F(LinkToAServer, SendsNothingForNobody) {
    instance.start();
    open(false);
    ASSERT_TRUE(becomes(ServerLink::There));
    request("walk");
    ASSERT_TRUE(isAnswered("walk"));
    EXPECT_EQ(told().replies["walk"].text, "no page is open any more");
    EXPECT_TRUE(instance.commands.empty());
}

TEST_F(LinkToAServer, HoldsKeysAndTaps) {
    instance.start();
    open();
    link->setKeys(KeySet().set('W').set(132));
    EXPECT_TRUE(instance.until([&] { return instance.keys.down['W'] && instance.keys.down[132]; }));
    link->setKeys(KeySet().set('W'));
    EXPECT_TRUE(instance.until([&] { return !instance.keys.down[132]; }));
    EXPECT_TRUE(instance.keys.down['W']);
    const std::vector<std::uint8_t> taps{' ', ' '};
    link->tap(taps);
    EXPECT_TRUE(instance.until([&] { return instance.presses[' '] == 2; }));
    EXPECT_FALSE(instance.keys.down[' ']);
    EXPECT_TRUE(instance.until([&] { return link->figures().keys.count() == 3; }));
    link.reset();
    EXPECT_TRUE(instance.until([&] { return instance.keys.down.none(); })) << "it lets all go at its end";
}

TEST_F(LinkToAServer, PressesHeldKeysOfTheNextServer) {
    instance.start();
    open();
    link->setKeys(KeySet().set('W'));
    ASSERT_TRUE(instance.until([&] { return instance.keys.down['W']; }));
    instance.stop();
    ASSERT_TRUE(becomes(ServerLink::Gone));
    instance.start();
    EXPECT_TRUE(instance.until([&] { return instance.keys.down['W']; }));
}

TEST_F(LinkToAServer, AddsTurnsUpWhileOneIsUnderWay) {
    instance.start();
    std::list<ipc::Command> waiting;
    instance.onCommand = [&](const ipc::Command& command) {
        if (!command.text.starts_with("camera turn")) return false;
        waiting.push_back(command);
        return true;
    };
    open();
    link->turn(1, 0);
    ASSERT_TRUE(instance.until([&] { return waiting.size() == 1; }));
    link->turn(2, 0.5);
    link->turn(4, 0.5);
    request("walk");
    ASSERT_TRUE(isAnswered("walk")) << "commands pass by";
    EXPECT_EQ(waiting.size(), 1U);
    instance.server().answer(waiting.front());
    ASSERT_TRUE(instance.until([&] { return waiting.size() == 2; }));
    EXPECT_EQ(waiting.front().text, "camera turn 1 0");
    EXPECT_EQ(waiting.back().text, "camera turn 6 1");
    link->turn(5, 0);
    link->dropTurn();
    instance.server().answer(waiting.back());
    request("fly");
    ASSERT_TRUE(isAnswered("fly"));
    EXPECT_EQ(waiting.size(), 2U) << "what was dropped is not sent";
}

TEST_F(LinkToAServer, AsksForTheStateAtFirstWhenToldToAndWhenItChanged) {
    instance.start();
    int asked = 0;
    instance.onCommand = [&](const ipc::Command& command) {
        if (command.text != "state") return false;
        ++asked;
        instance.server().answer(command, "the state");
        return true;
    };
    open();
    ASSERT_TRUE(instance.until([&] { return told().states.size() == 1; }));
    EXPECT_EQ(told().states.front(), "the state");
    link->refresh();
    ASSERT_TRUE(instance.until([&] { return told().states.size() == 2; }))
        << "the same, once it is asked for";
    const int before = asked;
    ipc::Status status;
    status.stateRevision = 1;
    instance.server().setStatus(status);
    ASSERT_TRUE(instance.until([&] { return asked > before; }))
        << "and when the server says that it is another";
    request("walk");
    ASSERT_TRUE(isAnswered("walk"));
    EXPECT_EQ(told().states.size(), 2U) << "which tells nothing, as nothing changed";
}

TEST_F(LinkToAServer, TellsTheStatusAndNewMessages) {
    instance.start();
    ipc::Status status;
    status.messages = 4;
    status.width = 320;
    instance.server().setStatus(status);
    Lines asked;
    instance.onCommand = [&](const ipc::Command& command) {
        if (!command.text.starts_with("messages")) return false;
        asked.push_back(command.text);
        instance.server().answer(command, "5 event light 2 off\n6 event light 2 on\n");
        return true;
    };
    open();
    ASSERT_TRUE(instance.until([&] { return told().status && told().status->width == 320; }));
    status.messages = 6;
    instance.server().setStatus(status);
    ASSERT_TRUE(instance.until([&] { return !told().messages.empty(); }));
    EXPECT_EQ(asked, Lines{"messages 4"}) << "those from before are none of its own";
    EXPECT_EQ(told().messages.front(), "5 event light 2 off\n6 event light 2 on\n");
    EXPECT_EQ(told().status->messages, 6U);
}

TEST_F(LinkToAServer, AsksForBindingsWithTheState) {
    instance.start();
    instance.onCommand = [&](const ipc::Command& command) {
        if (command.text != "bindings") return false;
        instance.server().answer(command, "W forward");
        return true;
    };
    open(true, app::KeyRestraint::Edits);
    ASSERT_TRUE(instance.until([&] { return !told().bindings.empty(); }));
    EXPECT_EQ(told().bindings.front(), "W forward");
}

} // namespace
