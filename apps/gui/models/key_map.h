/// From Qt's key events to the key codes that the server knows (rtcore/motion/key_codes.h).
#pragma once

class QKeyEvent;

namespace gui {

/// By the key, never by the text that it types: CapsLock, Shift and Ctrl do not change it. Digits go by their
/// place on the keyboard where the system tells it (a Czech keyboard types letters there); so do letters of
/// keyboards that are not Latin. KeyNone (0) for what the server does not know.
int keyCodeOf(const QKeyEvent& event);

} // namespace gui
