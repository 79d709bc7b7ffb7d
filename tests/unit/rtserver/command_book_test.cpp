#include "rtserver/commands/command_book.h"

#include <gtest/gtest.h>

#include <string>

namespace {

using rtserver::CommandBook;
using rtserver::Served;

ipc::Command command(int slot, std::uint64_t client, const std::string& text) {
    return {slot, client, 1, true, text};
}

/// Commands by their first letter: a(gain), b(eside), all others are done.
std::string serve(CommandBook& book) {
    std::string done;
    book.serve([&](const ipc::Command& c) {
        if (c.text[0] == 'a') return Served::Again;
        done += c.text + ' ';
        return c.text[0] == 'b' ? Served::Beside : Served::Done;
    });
    return done;
}

TEST(CommandBook, KeepsTheOrderOfAClientAndHoldsUpNoOther) {
    CommandBook book;
    for (const char* text : {"d1", "a1", "d2"}) book.add(command(0, 10, text));
    for (const char* text : {"d3", "d4"}) book.add(command(1, 20, text));
    EXPECT_TRUE(book.hasNew());
    EXPECT_EQ(serve(book), "d1 d3 d4 ");
    EXPECT_FALSE(book.hasNew());
    EXPECT_TRUE(book.waits());
    EXPECT_TRUE(book.hasMore(10));
    EXPECT_FALSE(book.hasMore(20));
    EXPECT_EQ(serve(book), "");
    const std::vector<ipc::Command> waiting = book.takeWaiting();
    ASSERT_EQ(waiting.size(), 1U);
    EXPECT_EQ(waiting[0].text, "a1");
    EXPECT_EQ(serve(book), "d2 ");
    EXPECT_FALSE(book.waits());
}

TEST(CommandBook, ASuccessorInTheSlotWaitsForNothing) {
    CommandBook book;
    book.add(command(0, 10, "a1"));
    for (int i = 0; i < 70; ++i) book.add(command(0, 10, "d1"));
    serve(book);
    EXPECT_FALSE(book.hasMore(11));
    book.add(command(0, 11, "d2"));
    EXPECT_EQ(serve(book), "d2 ");
    const std::vector<const ipc::Command*> full = book.ofClientsWith(64);
    ASSERT_EQ(full.size(), 1U);
    EXPECT_EQ(full[0]->client, 10U) << "not its successor";
    EXPECT_TRUE(book.ofClientsWith(100).empty());
}

TEST(CommandBook, KnowsWhoStandsInItsOwnWay) {
    CommandBook book;
    book.add(command(0, 10, "a1"));
    book.add(command(1, 20, "a2"));
    EXPECT_EQ(serve(book), "");
    EXPECT_FALSE(book.obstructs());
    book.add(command(0, 10, "d1"));
    EXPECT_TRUE(book.obstructs());
    const std::vector<ipc::Command> taken = book.takeObstructing();
    ASSERT_EQ(taken.size(), 1U);
    EXPECT_EQ(taken[0].text, "a1");
    EXPECT_TRUE(book.waits()) << "the other one";
    EXPECT_EQ(serve(book), "d1 ");
}

TEST(CommandBook, WhatIsBesideHoldsUpItsOwnClientOnly) {
    CommandBook book;
    for (const char* text : {"b1", "d1"}) book.add(command(0, 10, text));
    book.add(command(1, 20, "d2"));
    EXPECT_EQ(serve(book), "b1 d2 ");
    EXPECT_TRUE(book.isBeside(10));
    EXPECT_FALSE(book.waits()) << "no frame helps";
    EXPECT_TRUE(book.takeWaiting().empty());
    EXPECT_EQ(serve(book), "");
    book.resume(10);
    EXPECT_EQ(serve(book), "d1 ");
    EXPECT_FALSE(book.hasMore(10));
}

} // namespace
