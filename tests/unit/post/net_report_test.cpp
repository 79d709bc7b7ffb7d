#include "rtcore/post/net_report.h"

#include <gtest/gtest.h>

namespace rtcore {
namespace {

TEST(NetReport, SaysWhatANetDid) {
    NetReport report;
    EXPECT_EQ(textOf(report, DenoiseNet::Base), "");
    report.ran = true;
    EXPECT_EQ(textOf(report, DenoiseNet::Base), "denoised by base");
    report.estimated = true;
    report.error = 0.604F;
    report.largestError = 2.12F;
    EXPECT_EQ(textOf(report, DenoiseNet::Base), "denoised by base: +-0.60 of 255, largest 2.1");
    report.mixed = true;
    EXPECT_EQ(textOf(report, DenoiseNet::Large), "denoised by large and mixed: +-0.60 of 255, largest 2.1");
    report.dots = 35;
    report.lightOfDots = 0.0021F;
    EXPECT_EQ(textOf(report, DenoiseNet::Small),
              "denoised by small and mixed: +-0.60 of 255, largest 2.1; 35 bright dots, 0.21 % of the light, "
              "were kept from the net");
}

} // namespace
} // namespace rtcore
