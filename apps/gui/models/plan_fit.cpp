#include "gui/models/plan_fit.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace gui {

namespace {

using Numbers = std::array<double, 3>;

constexpr double kUpright = 0.98; ///< sine of a view's slope

template <typename Number>
double dot(const Numbers& a, const std::array<Number, 3>& b) {
    return a[0] * double{b[0]} + a[1] * double{b[1]} + a[2] * double{b[2]};
}

Numbers minus(const Numbers& a, const Numbers& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

template <typename Number>
Numbers plus(const Numbers& a, const std::array<Number, 3>& b, double factor) {
    return {a[0] + factor * double{b[0]}, a[1] + factor * double{b[1]}, a[2] + factor * double{b[2]}};
}

Numbers numbersIn(const QVector3D& v) { return {double{v.x()}, double{v.y()}, double{v.z()}}; }

app::ToldOutline withoutLines(const app::ToldOutline& outline) {
    app::ToldOutline frame = outline;
    frame.solids.clear();
    frame.lines.clear();
    frame.light.clear();
    return frame;
}

} // namespace

QSizeF planSize(const app::ToldOutline& outline, const QSizeF& area) {
    const QSizeF size(std::max(outline.size[0], 0), std::max(outline.size[1], 0));
    if (size.width() + size.height() <= 0) return {};
    // What is but a line has a width all the same.
    return size.expandedTo({1, 1}).scaled(area, Qt::KeepAspectRatio);
}

PlanFit::PlanFit(const app::ToldOutline& outline, const QRectF& area) : outline_(withoutLines(outline)) {
    const double larger = std::max({outline.size[0], outline.size[1], 1});
    const QSizeF size = planSize(outline, area.size());
    const double wide = std::max(outline.size[0], 1), high = std::max(outline.size[1], 1);
    const double scale = size.isEmpty() ? std::min(area.width(), area.height()) / larger
                                        : std::min(size.width() / wide, size.height() / high);
    const QPointF middle = area.center();
    fromSteps_.translate(middle.x() - scale * outline.size[0] / 2, middle.y() + scale * outline.size[1] / 2);
    fromSteps_.scale(scale, -scale);
    toSteps_ = fromSteps_.inverted();
}

QPointF PlanFit::at(const Numbers& position) const {
    const Numbers off = minus(position, outline_.corner);
    return fromSteps_.map(
        QPointF(dot(off, outline_.right) / outline_.step, dot(off, outline_.ahead) / outline_.step));
}

Numbers PlanFit::floorAt(const QPointF& point) const {
    const QPointF steps = toSteps_.map(point);
    return plus(plus(outline_.corner, outline_.right, steps.x() * outline_.step), outline_.ahead,
                steps.y() * outline_.step);
}

Numbers PlanFit::eyeAt(const QPointF& point, double height) const {
    const Numbers floor = floorAt(point);
    const double above = outline_.storey > 0 ? outline_.eyeHeight : height - heightOf(floor, outline_);
    return plus(floor, outline_.up, above);
}

QLineF PlanFit::directionOf(const View& view) const {
    const QPointF eye = at(positionOf(view.eye, view));
    const auto level = [this](const QVector3D& v) {
        return QPointF(dot(numbersIn(v), outline_.right), -dot(numbersIn(v), outline_.ahead));
    };
    const bool upright = std::fabs(dot(numbersIn(view.forward.normalized()), outline_.up)) > kUpright;
    QLineF line(eye, eye + level(upright ? view.up : view.forward));
    if (line.length() > 0) line.setLength(1);
    return line;
}

std::array<float, 3> PlanFit::turnedTo(const QPointF& point, const View& view) const {
    const Numbers eye = positionOf(view.eye, view), off = minus(floorAt(point), eye);
    const double right = dot(off, outline_.right), ahead = dot(off, outline_.ahead);
    const double away = std::hypot(right, ahead);
    if (!(away > 0)) return numbersOf(view.forward);
    double rises = dot(numbersIn(view.forward.normalized()), outline_.up);
    if (std::fabs(rises) > kUpright) rises = 0;
    const double level = std::sqrt(1 - rises * rises) / away;
    const Numbers turned = plus(plus(plus({}, outline_.right, right * level), outline_.ahead, ahead * level),
                                outline_.up, rises);
    return {static_cast<float>(turned[0]), static_cast<float>(turned[1]), static_cast<float>(turned[2])};
}

double heightOf(const Numbers& position, const app::ToldOutline& outline) {
    return dot(position, outline.up);
}

int groundFloor(const std::vector<double>& floors) {
    constexpr double kNear = 1.5; // metres
    if (floors.empty()) return 0;
    const auto nearest =
        std::ranges::min_element(floors, {}, [](double height) { return std::fabs(height); });
    return std::fabs(*nearest) <= kNear ? static_cast<int>(nearest - floors.begin()) + 1 : 1;
}

} // namespace gui
