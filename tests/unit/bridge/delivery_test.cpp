#include "bridge/stream/delivery.h"

#include <gtest/gtest.h>

namespace {

using bridge::Delivery;
using bridge::FrameSet;

bridge::SharedFrame frameOf(std::uint32_t stream, std::uint64_t number, std::size_t bytes,
                            bool exact = false) {
    auto frame = std::make_shared<bridge::EncodedFrame>();
    frame->facts = {stream, number, 1280, 720, 1280, 720, 0};
    frame->exact = exact;
    frame->bytes.resize(bytes);
    return frame;
}

FrameSet setOf(std::uint64_t number, int rung = bridge::kFirstRung, std::uint32_t stream = 1) {
    FrameSet set{stream, number, {}, nullptr, nullptr};
    set.byRung[static_cast<std::size_t>(rung)] = frameOf(stream, number, 1000);
    return set;
}

TEST(Delivery, SendsEachFrameOnceAndTheNewestOnly) {
    Delivery delivery;
    ASSERT_TRUE(delivery.next(setOf(1), 0));
    EXPECT_FALSE(delivery.next(setOf(1), 0));
    ASSERT_TRUE(delivery.next(setOf(2), 0));
    EXPECT_FALSE(delivery.next(setOf(3), 0)) << "two are under way";
    EXPECT_FALSE(delivery.wanted());
    delivery.rate().acked(1, 1, false, 0, 0.01);
    const auto next = delivery.next(setOf(9), 0.02);
    ASSERT_TRUE(next);
    EXPECT_EQ(next->frame->facts.number, 9U);
    EXPECT_FALSE(delivery.next(setOf(8), 0.03)) << "an older one";
}

TEST(Delivery, TakesACoarserRungWhereItsOwnIsMissing) {
    Delivery delivery;
    EXPECT_FALSE(delivery.next(setOf(1, 0), 0)) << "finer than it can take";
    EXPECT_TRUE(delivery.next(setOf(1, 3), 0));
}

TEST(Delivery, SendsNothingToAHiddenPage) {
    Delivery delivery;
    delivery.setView({.visible = false});
    EXPECT_FALSE(delivery.wanted());
    EXPECT_FALSE(delivery.next(setOf(1), 0));
    delivery.setView({.visible = true});
    EXPECT_TRUE(delivery.next(setOf(2), 0));
}

TEST(Delivery, BeginsAtHalfSizeOnASmallPage) {
    Delivery delivery;
    delivery.setView({.width = 400, .height = 225});
    delivery.next(setOf(1), 0);
    EXPECT_EQ(delivery.rate().rung(), bridge::kFirstHalfRung);
}

TEST(Delivery, SendsTheRestingImageInPartsOfTheFrameThatIsShown) {
    Delivery delivery;
    FrameSet set = setOf(1);
    set.still = frameOf(1, 1, 100'000, true);
    ASSERT_TRUE(delivery.next(set, 0));
    std::size_t offset = 0;
    for (int i = 0; offset < 100'000; ++i) {
        const auto part = delivery.next(set, 0.01 * i);
        ASSERT_TRUE(part) << offset;
        ASSERT_TRUE(part->part);
        EXPECT_EQ(part->offset, offset);
        EXPECT_LE(part->size, 32768U);
        offset += part->size;
        delivery.rate().acked(1, 1, true, 0, 0.01 * i + 0.005);
    }
    EXPECT_EQ(offset, 100'000U);
    EXPECT_FALSE(delivery.next(set, 1)) << "then silence";
}

TEST(Delivery, GivesTheRestingImageUpAtTheFirstMovement) {
    Delivery delivery;
    FrameSet set = setOf(1);
    set.still = frameOf(1, 1, 100'000, true);
    delivery.next(set, 0);
    delivery.next(set, 0);
    const auto moved = delivery.next(setOf(2), 0.01);
    ASSERT_TRUE(moved);
    EXPECT_FALSE(moved->part);
    EXPECT_FALSE(delivery.next(setOf(2), 0.02)) << "no part of an image that is not shown";
}

TEST(Delivery, KeepsPartsUnderWayFew) {
    Delivery delivery;
    FrameSet set = setOf(1);
    set.still = frameOf(1, 1, 10'000'000, true);
    delivery.next(set, 0);
    int parts = 0;
    while (parts < 100 && delivery.next(set, 0)) ++parts;
    EXPECT_LE(parts, 4);
}

TEST(Delivery, SendsNoStillOfAnotherFrameThanTheOneShown) {
    Delivery delivery;
    delivery.next(setOf(1), 0);
    FrameSet set{1, 2, {}, nullptr, frameOf(1, 2, 1000, true)};
    EXPECT_FALSE(delivery.next(set, 0.1));
}

TEST(Delivery, SendsNoStillToWhomSavesData) {
    Delivery delivery;
    delivery.setView({.saveData = true});
    EXPECT_EQ(delivery.rate().rung(), bridge::kFirstHalfRung);
    FrameSet set = setOf(1, 3);
    set.still = frameOf(1, 1, 1000, true);
    delivery.next(set, 0);
    EXPECT_FALSE(delivery.next(set, 0.1));
}

TEST(Delivery, PrefersARungWherePagesChooseNone) {
    Delivery delivery;
    delivery.prefer(2);
    delivery.setView({});
    EXPECT_EQ(delivery.rate().rung(), 2);
    delivery.setView({.rung = 4});
    EXPECT_EQ(delivery.rate().rung(), 4) << "a page's own choice";
    delivery.setView({.saveData = true});
    EXPECT_EQ(delivery.rate().rung(), bridge::kFirstHalfRung) << "less data counts first";
}

TEST(Delivery, TellsTheRungOfWhatIsSent) {
    Delivery delivery;
    const auto shipment = delivery.next(setOf(1, 3), 0);
    ASSERT_TRUE(shipment);
    EXPECT_EQ(shipment->rung, 3);
}

} // namespace
