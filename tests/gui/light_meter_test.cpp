/// The light at the pointer.
#include "gui/models/light_meter.h"
#include "gui/models/light_reading.h"

#include "gui/lit_scene.h"
#include "gui/window_support.h"

#include <QLabel>
#include <QLocale>

#include <utility>
#include <vector>

namespace gui {
namespace {

constexpr const char* kAnswer = "illuminance 512.3 lx, standard error 3.1\n"
                                "illuminance 300.0 lx of the sky, 212.3 lx of other light\n"
                                "luminance 120.1 cd/m2, standard error 1.0\nat 1 0.85 2";

class LightReadingTest : public testing::Test {
  protected:
    void SetUp() override { QLocale::setDefault(QLocale::c()); }
    void TearDown() override { QLocale::setDefault(before_); }
    QLocale before_;
};

TEST_F(LightReadingTest, IsReadFromTheAnswer) {
    const LightReading reading = lightReadingOf(QString::fromLatin1(kAnswer));
    ASSERT_TRUE(reading.illuminance && reading.luminance);
    EXPECT_DOUBLE_EQ(reading.illuminance->value, 512.3);
    EXPECT_DOUBLE_EQ(reading.illuminance->error, 3.1);
    EXPECT_EQ(reading.illuminance->decimals, 1);
    EXPECT_NEAR(reading.luminance->relativeError(), 1 / 120.1, 1e-9);
    EXPECT_EQ(lightText(reading), QStringLiteral("512.3 lx ± 3.1\n120.1 cd/m² ± 1.0"));
}

TEST_F(LightReadingTest, TellsOfLightWithoutAUnitAndOfNoSurface) {
    const LightReading sky = lightReadingOf(QStringLiteral(
        "luminance 0 cd/m2, standard error 0\nthe light of this scene has no absolute unit: the background"));
    EXPECT_FALSE(sky.illuminance);
    EXPECT_EQ(sky.luminance->relativeError(), 0);
    EXPECT_EQ(lightText(sky), QStringLiteral("0 cd/m² ± 0\nsome light has no absolute unit"));
    EXPECT_EQ(lightText({}), QString());
    EXPECT_EQ(lightText(lightReadingOf(QStringLiteral("nonsense"))), QString());
}

/// A meter and a server that answers when it is told.
struct MeterAndServer {
    std::vector<std::string> sent;
    std::function<void(const Answer&)> waiting;
    LightMeter meter{[this](const std::string& line, std::function<void(const Answer&)> done) {
        sent.push_back(line);
        if (line.starts_with("measure light")) waiting = std::move(done);
    }};

    void answer(const QString& text, bool done = true) {
        ASSERT_TRUE(waiting);
        std::exchange(waiting, nullptr)({.done = done, .text = text});
    }
};

QString luminance(double error) {
    return QStringLiteral("luminance 100.00 cd/m2, standard error %1").arg(error, 0, 'f', 2);
}

TEST(LightMeter, AsksForMorePathsUntilTheErrorIsSmall) {
    MeterAndServer s;
    s.meter.measure({0.5, 0.25});
    EXPECT_EQ(s.sent.back(), "measure light 0.5 0.25 8192");
    s.answer(luminance(4));
    EXPECT_DOUBLE_EQ(s.meter.reading().luminance->error, 4);
    EXPECT_EQ(s.sent.back(), "measure light 0.5 0.25 32768");
    s.answer(luminance(2));
    EXPECT_DOUBLE_EQ(s.meter.reading().luminance->error, 2);
    EXPECT_FALSE(s.meter.done());
    s.answer(luminance(0.4));
    EXPECT_EQ(s.sent.size(), 3U);
    EXPECT_TRUE(s.meter.done());
}

TEST(LightMeter, EndsAtHalfAMillionPaths) {
    MeterAndServer s;
    s.meter.measure({0, 0});
    while (s.waiting) s.answer(luminance(9));
    EXPECT_EQ(s.sent.back(), "measure light 0 0 524288");
}

TEST(LightMeter, DropsWhatIsOutOfDate) {
    MeterAndServer s;
    s.meter.measure({0.5, 0.5});
    s.meter.forget();
    s.meter.measure({0.25, 0.5});
    EXPECT_EQ(s.sent.size(), 1U) << "one at a time, and no stop to what may be another client's";
    s.answer(luminance(1));
    EXPECT_FALSE(s.meter.reading().luminance) << "of the point before";
    EXPECT_EQ(s.sent.back(), "measure light 0.25 0.5 8192");
    s.answer(luminance(9));
    EXPECT_TRUE(s.meter.reading().luminance);
    s.meter.forget();
    EXPECT_FALSE(s.meter.reading().luminance);
    EXPECT_EQ(s.sent.back(), "measure stop") << "a long one, which its own first answer came before";
}

TEST(LightMeter, GivesUpWhileAnotherMeasures) {
    MeterAndServer s;
    s.meter.measure({0.5, 0.5});
    s.answer(QStringLiteral("light is being measured already"), false);
    EXPECT_TRUE(s.meter.done());
    s.meter.measure({0.5, 0.5});
    EXPECT_EQ(s.sent.size(), 2U);
    s.answer(luminance(0.4));
    EXPECT_TRUE(s.meter.reading().luminance);
    s.meter.glance({0.5, 0.5});
    s.answer(QStringLiteral("light is being measured already"), false);
    EXPECT_FALSE(s.meter.reading().luminance) << "it was that of another view";
}

TEST(LightMeter, GlancesWhileTheViewMoves) {
    MeterAndServer s;
    s.meter.glance({0.5, 0.5});
    EXPECT_EQ(s.sent.back(), "measure light 0.5 0.5 512");
    s.meter.glance({0.5, 0.75});
    EXPECT_EQ(s.sent.size(), 1U) << "one after the other";
    s.answer(luminance(9));
    EXPECT_TRUE(s.meter.reading().luminance);
    EXPECT_TRUE(s.meter.done()) << "a glance is not repeated by itself";
    s.meter.glance({0.5, 0.25});
    EXPECT_TRUE(s.meter.reading().luminance) << "until the next answer";
    s.meter.measure({0.5, 0.25});
    s.answer(luminance(8));
    EXPECT_DOUBLE_EQ(s.meter.reading().luminance->error, 8);
    EXPECT_EQ(s.sent.back(), "measure light 0.5 0.25 8192") << "it rests";
    s.answer(luminance(4));
    EXPECT_EQ(s.sent.back(), "measure light 0.5 0.25 32768");
    s.meter.glance({0.5, 0.5});
    EXPECT_EQ(s.sent.back(), "measure stop");
    s.answer(luminance(1));
    EXPECT_DOUBLE_EQ(s.meter.reading().luminance->error, 4) << "of the view before";
    s.meter.glance({0.5, 0.5});
    EXPECT_EQ(s.sent.back(), "measure light 0.5 0.5 512");
}

class LightMeterWindow : public test::WindowFixture {};

TEST_F(LightMeterWindow, ShowsTheLightAtThePointerWhileItIsOn) {
    test::writeLitScene(folder());
    ASSERT_NO_FATAL_FAILURE(openAndRest("lit.scn"));
    const auto* label = window->findChild<QLabel*>(QStringLiteral("lightMeter"));
    ASSERT_NE(label, nullptr);
    const auto moveTo = [&](const QPoint& at) {
        QWidget& view = window->view();
        QMouseEvent event(QEvent::MouseMove, at, view.mapToGlobal(at), Qt::NoButton, Qt::NoButton, {});
        QApplication::sendEvent(&view, &event);
    };
    const QPoint middle = window->view().pictureArea().center().toPoint();
    moveTo(middle);
    EXPECT_FALSE(label->isVisible()) << "it is off";
    action(ActionId::LightMeter)->trigger();
    moveTo(middle + QPoint(1, 1));
    ASSERT_TRUE(test::comes([&] { return label->isVisible(); }));
    EXPECT_TRUE(label->text().contains(QStringLiteral("cd/m²"))) << label->text().toStdString();
    EXPECT_TRUE(label->text().contains(QStringLiteral("lx ±"))) << label->text().toStdString();
    QTest::keyPress(&window->view(), Qt::Key_W);
    const QString before = label->text();
    EXPECT_TRUE(test::comes([&] { return label->text() != before; })) << "while the view moves";
    EXPECT_TRUE(label->isVisible());
    QTest::keyRelease(&window->view(), Qt::Key_W);
    ASSERT_TRUE(test::comes([&] { return status().idle; }));
    moveTo(middle + QPoint(5, 3));
    EXPECT_FALSE(label->isVisible()) << "until the other point is measured";
    EXPECT_TRUE(test::comes([&] { return label->isVisible(); }));
    action(ActionId::LightMeter)->trigger();
    EXPECT_FALSE(label->isVisible());
}

TEST_F(LightMeterWindow, MeasuresOnWhateverIsWrittenBesideTheImage) {
    test::writeLitScene(folder());
    ASSERT_NO_FATAL_FAILURE(openAndRest("lit.scn"));
    const auto* label = window->findChild<QLabel*>(QStringLiteral("lightMeter"));
    action(ActionId::LightMeter)->trigger();
    QWidget& view = window->view();
    const QPoint middle = window->view().pictureArea().center().toPoint();
    QMouseEvent event(QEvent::MouseMove, middle, view.mapToGlobal(middle), Qt::NoButton, Qt::NoButton, {});
    QApplication::sendEvent(&view, &event);
    ASSERT_TRUE(test::comes([&] { return label->isVisible(); }));
    bool hidden = false;
    const auto watch = [&] { hidden = hidden || !label->isVisible(); };
    QObject::connect(&window->session(), &Session::statusChanged, label, watch);
    ASSERT_TRUE(ask(window->session(), QStringLiteral("note add 0 0 0 dark")).done);
    ASSERT_TRUE(test::comes([&] { return window->editor().state().notes.size() == 1; }));
    ASSERT_TRUE(ask(window->session(), QStringLiteral("measure keep distance 0 0 0 1 0 0")).done);
    ASSERT_TRUE(test::comes([&] { return window->editor().state().measureCount == 1; }));
    EXPECT_FALSE(hidden);
    ASSERT_TRUE(ask(window->session(), QStringLiteral("light 1 toggle")).done);
    EXPECT_TRUE(test::comes([&] { return hidden; })) << "the light is another";
}

} // namespace
} // namespace gui
