/// Hands for dialogs.
#pragma once

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QDialog>
#include <QDialogButtonBox>
#include <QString>
#include <QWidget>

namespace test {

inline void accept(QDialog& dialog) {
    auto* buttons = dialog.findChild<QDialogButtonBox*>();
    for (QAbstractButton* button : buttons->buttons()) {
        if (buttons->buttonRole(button) == QDialogButtonBox::AcceptRole) button->click();
    }
}

/// Null, and a failure, when there is none.
template <typename Field>
Field* field(const QWidget& dialog, const char* accessibleName) {
    for (Field* each : dialog.findChildren<Field*>()) {
        if (each->accessibleName() == QLatin1String(accessibleName)) return each;
    }
    ADD_FAILURE() << "no field " << accessibleName;
    return nullptr;
}

/// Clicks the first button that can be clicked and whose text, without its mnemonic, holds `word`.
inline bool press(const QWidget& dialog, const char* word) {
    for (QAbstractButton* button : dialog.findChildren<QAbstractButton*>()) {
        if (!button->isEnabled() || !button->text().remove(QLatin1Char('&')).contains(QLatin1String(word)))
            continue;
        button->click();
        return true;
    }
    return false;
}

} // namespace test
