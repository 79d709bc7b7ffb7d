// The manual's numbers on walking are those of the code.
#include "rtcore/motion/walk_shape.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <string>

namespace {

std::string textOf(const std::string& file) {
    std::ifstream stream(std::string(RT_SOURCE_FOLDER "/docs/") + file);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

/// To the centimetre, with as many digits as are asked for at least.
std::string number(double value, int digits) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.2f", value);
    std::string result = text.data();
    const std::size_t point = result.find('.');
    while (result.ends_with('0') && result.size() > point + 1 + static_cast<std::size_t>(digits))
        result.pop_back();
    return result;
}

const rtcore::WalkShape kUsual;

TEST(Manual, TellsHowHeWalks) {
    const std::string manual = textOf("manual.md");
    const rtcore::WalkShape& s = kUsual;
    const std::string rows[] = {
        "| height; the eye is " + number(s.eyeBelowTop, 2) + " m below | " + number(s.stand.height, 2) +
            " m | " + number(s.crouch.height, 2) + " m | " + number(s.crawl.height, 2) + " m |\n",
        "| speed | " + number(s.stand.speed, 1) + " m/s | " + number(s.crouch.speed, 1) + " m/s | " +
            number(s.crawl.speed, 1) + " m/s |\n",
        "| highest step | " + number(s.stand.step, 2) + " m | " + number(s.crouch.step, 2) + " m | " +
            number(s.crawl.step, 2) + " m |\n",
        "| jump (Space) | " + number(s.stand.jump, 1) + " m | " + number(s.crouch.jump, 1) + " m | |\n",
        "- Shift: " + number(s.sprint * s.stand.speed, 1) + " m/s forwards, when standing.\n",
        "capsule " + number(2 * (s.radius + s.skin), 1) + " m thick",
        "at most " + number(s.ledge, 1) + " m higher than the last floor"};
    for (const std::string& row : rows)
        EXPECT_NE(manual.find(row), std::string::npos) << "docs/manual.md should say: " << row;
    EXPECT_EQ(s.crawl.jump, 0);
}

TEST(Manual, NamesTheDefaultsOfAScene) {
    const std::string formats = textOf("formats.md");
    const rtcore::WalkParameters walk;
    const std::string text = "height = " + number(double{walk.height}, 1) +
                             "\nspeed = " + number(double{walk.speed}, 1) +
                             "\njumpHeight = " + number(double{walk.jumpHeight}, 1) +
                             "\nstepHeight = " + number(double{walk.stepHeight}, 1) +
                             "\ngravity = " + number(double{walk.gravity}, 2) + "\n";
    EXPECT_NE(formats.find(text), std::string::npos) << "docs/formats.md should say:\n" << text;
}

} // namespace
