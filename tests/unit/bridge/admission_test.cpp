// A driver's link is good once; the page that it let in comes back by a token of its own.
#include "bridge/admission.h"

#include <gtest/gtest.h>

namespace {

using bridge::Admission;
using bridge::Right;

constexpr const char *kDriver = "driver-driver-driver-driver", *kViewer = "viewer-viewer-viewer-viewer";

class Admissions : public testing::Test {
  protected:
    Admission admission{{.driver = kDriver, .viewer = kViewer}};
};

TEST_F(Admissions, OfTheDriversLinkAreOne) {
    EXPECT_EQ(admission.rightOf(kDriver, 0), Right::Drive);
    const Admission::Entered first = admission.enter(kDriver, 0);
    EXPECT_TRUE(first.linkUsed);
    EXPECT_EQ(first.own.size(), 43U);
    EXPECT_EQ(admission.rightOf(kDriver, 0), Right::Used);
    EXPECT_EQ(admission.rightOf(first.own, 0), Right::Drive);
    const std::string next = admission.links().driver;
    EXPECT_NE(next, kDriver);
    EXPECT_NE(next, first.own);
    const Admission::Entered second = admission.enter(next, 1);
    EXPECT_TRUE(second.linkUsed);
    EXPECT_NE(second.own, first.own);
    EXPECT_EQ(admission.rightOf(first.own, 1), Right::Drive) << "one lets the other be";
    EXPECT_EQ(admission.rightOf("", 1), Right::None);
    EXPECT_EQ(admission.rightOf("driver-driver-driver-drivel", 1), Right::None);
}

TEST_F(Admissions, OfViewersHaveNoEnd) {
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(admission.rightOf(kViewer, i), Right::View);
        EXPECT_EQ(admission.enter(kViewer, i).own, "");
    }
    EXPECT_EQ(admission.links().driver, kDriver);
}

TEST_F(Admissions, ByAFilesLinkHaveNoEnd) {
    Admission lasting({.driver = kDriver, .viewer = kViewer, .lasting = true});
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(lasting.rightOf(kDriver, i), Right::Drive);
        EXPECT_EQ(lasting.enter(kDriver, i).own, "");
    }
}

TEST_F(Admissions, OfAPageThatIsLoadedAgainLastAMinute) {
    const std::string own = admission.enter(kDriver, 0).own;
    admission.left(own, true, 100);
    EXPECT_EQ(admission.rightOf(own, 159), Right::Drive);
    EXPECT_EQ(admission.enter(own, 159).own, own);
    EXPECT_EQ(admission.rightOf(own, 9999), Right::Drive) << "it is there";
    admission.left(own, true, 10'000);
    EXPECT_EQ(admission.rightOf(own, 10'061), Right::None) << "what a browser kept of it is worth nothing";
    EXPECT_EQ(admission.enter(own, 10'061).own, "");
}

TEST_F(Admissions, OfAPageThatWasLostLastAnHour) {
    const std::string own = admission.enter(kDriver, 0).own;
    admission.left(own, false, 0);
    EXPECT_EQ(admission.rightOf(own, 3599), Right::Drive);
    EXPECT_EQ(admission.rightOf(own, 3601), Right::None);
}

// The bridge sees the end of a connection after the page has come back by another one.
TEST_F(Admissions, LastWhileAnyPageIsThere) {
    const std::string own = admission.enter(kDriver, 0).own;
    admission.enter(own, 10);
    admission.left(own, true, 20);
    EXPECT_EQ(admission.rightOf(own, 1000), Right::Drive);
    admission.left(own, true, 1000);
    EXPECT_EQ(admission.rightOf(own, 1061), Right::None);
    admission.left(own, true, 1061);
    admission.left("", false, 1061);
}

} // namespace
