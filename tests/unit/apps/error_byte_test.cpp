#include "common/frames/error_byte.h"

#include <gtest/gtest.h>

namespace {

TEST(ErrorByte, KeepsErrorsToSomeHundredthsUpToAHundredCodes) {
    EXPECT_EQ(app::errorByte(0), 0);
    EXPECT_EQ(app::errorOfByte(0), 0);
    for (float error = 0.1F; error < 98; error *= 1.07F)
        EXPECT_NEAR(app::errorOfByte(app::errorByte(error)), error, 0.02F * error + 0.002F);
    EXPECT_EQ(app::errorByte(1e30F), 255);
    for (int byte = 0; byte < 256; ++byte)
        EXPECT_EQ(app::errorByte(app::errorOfByte(static_cast<std::uint8_t>(byte))), byte);
}

} // namespace
