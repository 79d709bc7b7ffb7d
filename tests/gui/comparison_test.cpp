/// Comparing the shown image with one that was kept.
#include "gui/window_support.h"

#include "gui/view/comparison.h"

#include <QAction>

namespace {

using namespace test;
using namespace gui;

QImage filled(const QSize& size, QRgb colour) {
    QImage image(size, QImage::Format_RGB32);
    image.fill(colour);
    return image;
}

TEST(ImageDifference, IsMeasuredAndBrightened) {
    QImage one = filled({4, 2}, qRgb(100, 100, 100)), two = one;
    EXPECT_EQ(differenceOf(one, two).largest, 0);
    EXPECT_EQ(differenceOf(one, two).image, filled({4, 2}, qRgb(0, 0, 0)));
    two.setPixel(1, 1, qRgb(110, 95, 100));
    const ImageDifference found = differenceOf(one, two);
    EXPECT_EQ(found.largest, 10);
    EXPECT_DOUBLE_EQ(found.mean, 15.0 / 24);
    EXPECT_EQ(found.times, 25);
    EXPECT_EQ(found.image.pixel(1, 1), qRgb(250, 125, 0));
    EXPECT_EQ(found.image.pixel(0, 0), qRgb(0, 0, 0));
}

TEST(ImageDifference, OfImagesOfOtherSizesIsOfTheShownOne) {
    const ImageDifference found =
        differenceOf(filled({8, 8}, qRgb(10, 10, 10)), filled({4, 6}, qRgb(10, 10, 12)));
    EXPECT_EQ(found.image.size(), QSize(4, 6));
    EXPECT_EQ(found.largest, 2);
    EXPECT_EQ(found.times, 64);
}

class ComparisonTest : public WindowFixture {
  protected:
    void SetUp() override {
        WindowFixture::SetUp();
        window->preferences().set(pref::progressiveRendering, false);
        openAndRest();
        comparison = window->view().findChild<Comparison*>();
        ASSERT_NE(comparison, nullptr);
    }
    FrameView& view() { return window->view(); }
    /// Another image than that of the server, so that sides differ.
    void showRed() { view().showPicture(filled(view().shown().size(), qRgb(200, 0, 0))); }
    QRgb seenAt(double x) {
        const QRectF area = view().pictureArea();
        const QPointF at(area.left() + x * area.width(), area.top() + area.height() / 4);
        return grabbed().pixel(at.toPoint());
    }
    bool isRed(QRgb seen) { return qRed(seen) > 150 && qGreen(seen) < 60 && qBlue(seen) < 60; }

    Comparison* comparison = nullptr;
};

TEST_F(ComparisonTest, SaysWhatIsMissingWhereNothingIsKept) {
    action(ActionId::CompareDivider)->trigger();
    EXPECT_FALSE(action(ActionId::CompareDivider)->isChecked());
    EXPECT_EQ(comparison->mode(), CompareMode::Off);
    EXPECT_TRUE(view().told().contains(QStringLiteral("Ctrl+Alt+K"))) << view().told().toStdString();
}

TEST_F(ComparisonTest, ADividerShowsTheKeptImageOnItsLeftAndIsDragged) {
    action(ActionId::KeepImage)->trigger();
    showRed();
    action(ActionId::CompareDivider)->trigger();
    EXPECT_FALSE(isRed(seenAt(0.3)));
    EXPECT_TRUE(isRed(seenAt(0.7)));
    const QRectF area = view().pictureArea();
    const auto at = [&](double x) {
        return QPointF(area.left() + x * area.width(), area.center().y()).toPoint();
    };
    const auto before = status().view;
    QTest::mousePress(&view(), Qt::LeftButton, {}, at(0.5));
    QTest::mouseMove(&view(), at(0.6));
    QTest::mouseRelease(&view(), Qt::LeftButton, {}, at(0.6));
    EXPECT_NEAR(comparison->divider(), 0.6, 0.02);
    EXPECT_FALSE(isRed(seenAt(0.55)));
    EXPECT_TRUE(isRed(seenAt(0.7)));
    EXPECT_FALSE(view().input().captured());
    EXPECT_EQ(status().view, before);
    action(ActionId::CompareDivider)->trigger();
    EXPECT_TRUE(isRed(seenAt(0.3)));
}

TEST_F(ComparisonTest, OneWayAtATime) {
    action(ActionId::KeepImage)->trigger();
    showRed();
    action(ActionId::CompareBlink)->trigger();
    EXPECT_EQ(comparison->mode(), CompareMode::Blink);
    EXPECT_TRUE(comes([&] { return comparison->showsKept() && !isRed(seenAt(0.5)); }));
    EXPECT_TRUE(comes([&] { return !comparison->showsKept() && isRed(seenAt(0.5)); }));
    action(ActionId::CompareDifference)->trigger();
    EXPECT_EQ(comparison->mode(), CompareMode::Difference);
    EXPECT_FALSE(action(ActionId::CompareBlink)->isChecked());
    action(ActionId::KeepImage)->trigger(); // the red one
    EXPECT_TRUE(comes([&] { return seenAt(0.5) == qRgb(0, 0, 0); }));
    action(ActionId::CompareDifference)->trigger();
    EXPECT_EQ(comparison->mode(), CompareMode::Off);
    EXPECT_TRUE(isRed(seenAt(0.5)));
}

} // namespace
