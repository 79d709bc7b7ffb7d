// The effect of each drag in each scheme; none of the modifiers is a key that moves the camera by itself.
#include "gui/models/bindings.h"
#include "gui/models/mouse_scheme.h"

#include <gtest/gtest.h>

namespace gui {
namespace {

constexpr Drag kNone = Drag::None, kTurns = Drag::Turns, kMoves = Drag::Moves, kNears = Drag::Nears;

/// Drags by the left, middle and right button: alone, with Shift, with Ctrl, with both.
struct Expected {
    MouseScheme scheme;
    Drag drags[3][4];
};
constexpr Expected kTable[]{
    {MouseScheme::Usual,
     {{kTurns, kMoves, kTurns, kMoves}, {kMoves, kMoves, kMoves, kMoves}, {kNone, kNone, kNone, kNone}}},
    {MouseScheme::F3d,
     {{kTurns, kMoves, kTurns, kMoves}, {kMoves, kMoves, kMoves, kMoves}, {kNears, kNears, kNears, kNears}}},
    {MouseScheme::Blender,
     {{kNone, kNone, kNone, kNone}, {kTurns, kMoves, kNears, kMoves}, {kNone, kNone, kNone, kNone}}}};
constexpr Qt::MouseButton kButtons[]{Qt::LeftButton, Qt::MiddleButton, Qt::RightButton};
const Qt::KeyboardModifiers kModifiers[]{Qt::NoModifier, Qt::ShiftModifier, Qt::ControlModifier,
                                         Qt::ShiftModifier | Qt::ControlModifier};

TEST(MouseSchemes, SayWhatEachDragDoes) {
    for (const Expected& each : kTable) {
        for (int button = 0; button < 3; ++button) {
            bool any = false;
            for (int with = 0; with < 4; ++with) {
                const Drag does = dragOf(each.scheme, kButtons[button], kModifiers[with]);
                EXPECT_EQ(does, each.drags[button][with])
                    << nameOf(each.scheme).toStdString() << ' ' << button << ' ' << with;
                any = any || does != Drag::None;
            }
            EXPECT_EQ(hasDrags(each.scheme, kButtons[button]), any);
        }
        EXPECT_EQ(mouseSchemeNamed(nameOf(each.scheme)), each.scheme);
    }
    EXPECT_EQ(mouseSchemeNamed(QStringLiteral("maya")), MouseScheme::Usual);
}

// Alone they change how fast or how low the camera goes while another key is down; no drag needs one.
TEST(MouseSchemes, HaveModifiersThatMoveNothingAlone) {
    for (const Binding& binding : defaultBindings()) {
        const bool modifier = binding.keys == QLatin1String("Shift") ||
                              binding.keys == QLatin1String("Control") ||
                              binding.keys == QLatin1String("Ctrl");
        EXPECT_TRUE(!modifier || binding.action == QLatin1String("sprint") ||
                    binding.action == QLatin1String("crouch") || binding.action == QLatin1String("crawl"))
            << binding.keys.toStdString() << ' ' << binding.action.toStdString();
    }
    for (const Expected& each : kTable) {
        for (const DragRow& row : dragsOf(each.scheme))
            EXPECT_FALSE(row.modifiers.testFlag(Qt::AltModifier)) << "desktops move windows by it";
    }
}

} // namespace
} // namespace gui
