/// A model on a national grid, as its author knows it: coordinates of its file at every door.
#include "process/server/live_server.h"

#include "rtcore/io/images/image_file.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>

namespace {

using namespace test;
using Point = std::array<double, 3>;

constexpr Point kGrid{458213, 5428765, 312};

/// Fixture: room.obj, and far.obj, the same on the grid.
class FarModel : public LiveServer {
  protected:
    void SetUp() override {
        LiveServer::SetUp();
        std::ifstream in(folder() / "room.obj");
        std::ofstream out(folder() / "far.obj");
        for (std::string line; std::getline(in, line);) {
            Point p{};
            if (std::sscanf(line.c_str(), "v %lf %lf %lf", &p[0], &p[1], &p[2]) == 3) {
                out << "v " << joined(onGrid(p)) << '\n';
            } else {
                out << line << '\n';
            }
        }
    }
    static Point onGrid(const Point& p) { return {p[0] + kGrid[0], p[1] + kGrid[1], p[2] + kGrid[2]}; }
    static std::string text(double value) {
        std::array<char, 40> digits{};
        std::snprintf(digits.data(), digits.size(), "%.12g", value);
        return digits.data();
    }
    static std::string joined(const Point& p) { return text(p[0]) + " " + text(p[1]) + " " + text(p[2]); }

    void look(const Point& eye, const Point& at) const {
        Names words{"camera", "look-at"};
        for (const Point& p : {eye, at})
            for (const double v : p) words.push_back(text(v));
        words.push_back("60");
        ask(words);
    }
    /// The picture of the view that is shown.
    rtcore::LdrImage picture(const std::string& name) const {
        ask({"wait-idle"});
        ask({"screenshot", name});
        return rtcore::readLdrImage(folder() / name);
    }
    Point eye() const {
        const auto status = nlohmann::json::parse(ask({"status", "--json"}));
        return status["eye"].get<Point>();
    }
    void stop() {
        ask({"exit"});
        server->wait();
    }
};

double meanDifference(const rtcore::LdrImage& a, const rtcore::LdrImage& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const auto &p = a.pixels[i], &q = b.pixels.at(i);
        sum += std::abs(p.r - q.r) + std::abs(p.g - q.g) + std::abs(p.b - q.b);
    }
    return sum / (3.0 * 255 * static_cast<double>(a.pixels.size()));
}

void expectNear(const Point& a, const Point& b) {
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], 1e-6);
}

TEST_F(FarModel, LooksAsItDoesNearZero) {
    constexpr Point kEye{3.3, 2.1, 6.7}, kAt{0.2, 0.4, -1.1};
    start();
    look(kEye, kAt);
    const rtcore::LdrImage near = picture("near.png");
    stop();
    start({}, "far.obj");
    look(onGrid(kEye), onGrid(kAt));
    expectNear(eye(), onGrid(kEye));
    EXPECT_LT(meanDifference(picture("far.png"), near), 0.001);
}

TEST_F(FarModel, ItsCoordinatesAreKept) {
    constexpr Point kEye{3.3, 2.1, 6.7}, kLight{-1.2, 4.6, 2.05};
    start({}, "far.obj");
    look(onGrid(kEye), onGrid({0.2, 0.4, -1.1}));
    const Point light = onGrid(kLight);
    const std::string id =
        ask({"light", "add", "point", "at", text(light[0]), text(light[1]), text(light[2])});
    ask({"export", "camera", "view.cam"});
    const std::string camera = ask({"camera", "get"});
    ask({"save", "as", "far.scn"});
    picture("before.png");
    stop();
    start({}, "far.scn");
    expectNear(eye(), onGrid(kEye));
    picture("after.png");
    EXPECT_EQ(bytes("after.png"), bytes("before.png"));
    const std::string told = ask({"light", "get", id.substr(0, id.find('\n'))});
    Point position{};
    ASSERT_EQ(std::sscanf(told.substr(told.find("position")).c_str(), "position = [%lf, %lf, %lf]",
                          &position[0], &position[1], &position[2]),
              3)
        << told;
    expectNear(position, light);
    // The same camera from its file, by the scene and by hand.
    ask({"camera", "turn", "20", "5"});
    ask({"load", "camera", "view.cam"});
    EXPECT_EQ(ask({"camera", "get"}), camera);
    const std::string p =
        text(kEye[0] + kGrid[0]) + ", " + text(kEye[1] + kGrid[1]) + ", " + text(kEye[2] + kGrid[2]);
    writeText(folder() / "hand.cam", "version = 1\neye = [" + p + "]\nforward = [0, 0, -1]\n");
    ask({"load", "camera", "hand.cam"});
    expectNear(eye(), onGrid(kEye));
}

TEST_F(FarModel, OneWalksOnItsFloor) {
    start({"--units=m"}, "far.obj");
    look(onGrid({4.3, 2.1, -1}), onGrid({4.3, 2.1, -11}));
    ask({"walk"});
    ask({"key", "press", "w", "400"});
    ask({"key", "release", "all"});
    const Point now = eye();
    EXPECT_NEAR(now[1], kGrid[1] - 0.5 + 1.7, 0.3); // the floor's top lies half a unit below zero
    EXPECT_LT(now[2], kGrid[2] - 1.2);
}

} // namespace
