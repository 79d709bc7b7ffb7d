#include "gui/models/key_map.h"

#include "rtcore/motion/key_codes.h"

#include <QGuiApplication>
#include <QKeyEvent>

#include <array>
#include <string_view>
#include <utility>

namespace gui {

namespace {

constexpr std::array kNamed{
    std::pair{Qt::Key_Tab, rtcore::KeyTab},
    std::pair{Qt::Key_Backtab, rtcore::KeyTab},
    std::pair{Qt::Key_Return, rtcore::KeyReturn},
    std::pair{Qt::Key_Enter, rtcore::KeyReturn},
    std::pair{Qt::Key_Escape, rtcore::KeyEscape},
    std::pair{Qt::Key_Space, rtcore::KeySpace},
    std::pair{Qt::Key_Left, rtcore::KeyLeft},
    std::pair{Qt::Key_Right, rtcore::KeyRight},
    std::pair{Qt::Key_Up, rtcore::KeyUp},
    std::pair{Qt::Key_Down, rtcore::KeyDown},
    std::pair{Qt::Key_Shift, rtcore::KeyShift},
    std::pair{Qt::Key_Control, rtcore::KeyControl},
    std::pair{Qt::Key_Alt, rtcore::KeyAlt},
    std::pair{Qt::Key_CapsLock, rtcore::KeyCapsLock},
    std::pair{Qt::Key_PageUp, rtcore::KeyPageUp},
    std::pair{Qt::Key_PageDown, rtcore::KeyPageDown},
    std::pair{Qt::Key_Home, rtcore::KeyHome},
    std::pair{Qt::Key_End, rtcore::KeyEnd},
    std::pair{Qt::Key_Insert, rtcore::KeyInsert},
    std::pair{Qt::Key_Delete, rtcore::KeyDelete},
    std::pair{Qt::Key_Backspace, rtcore::KeyBackspace},
};

// X11 and Wayland number the places of keys: four rows, beginning at these codes.
struct Row {
    quint32 first;
    std::string_view keys;
};
constexpr std::array kKeyRows{Row{10, "1234567890"}, Row{24, "QWERTYUIOP"}, Row{38, "ASDFGHJKL"},
                              Row{52, "ZXCVBNM"}};

bool placesAreKnown() {
    static const bool known = QGuiApplication::platformName() == QLatin1String("xcb") ||
                              QGuiApplication::platformName().startsWith(QLatin1String("wayland"));
    return known;
}

int byPlace(quint32 place) {
    if (!placesAreKnown()) return rtcore::KeyNone;
    for (const Row& row : kKeyRows) {
        if (place >= row.first && place - row.first < row.keys.size()) return row.keys[place - row.first];
    }
    return rtcore::KeyNone;
}

} // namespace

int keyCodeOf(const QKeyEvent& event) {
    for (const auto& [qtKey, code] : kNamed) {
        if (event.key() == qtKey) return code;
    }
    const int place = byPlace(event.nativeScanCode());
    if (place >= '0' && place <= '9') return place;
    const bool ascii = event.key() > ' ' && event.key() < 127;
    return ascii ? event.key() : place;
}

} // namespace gui
