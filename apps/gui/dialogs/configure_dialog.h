/// Preferences and key bindings.
#pragma once

#include "gui/models/bindings.h"
#include "gui/models/preferences.h"

#include <QDialog>

#include <functional>

class QCheckBox;
class QFormLayout;
class QPushButton;
class QSpinBox;

namespace gui {

class KeyBindingsPage;
class Session;

class ConfigureDialog : public QDialog {
    Q_OBJECT

  public:
    /// Both must outlive it. Nothing changes before the user accepts.
    ConfigureDialog(Preferences& preferences, Session& session, QWidget* parent = nullptr);

  private:
    QWidget* generalPage();
    QWidget* picturePage();
    QWidget* inputPage();
    void addSwitch(QFormLayout& form, const QString& text, const Preference<bool>& row);
    void addNumber(QFormLayout& form, const QString& text, const Preference<int>& row, int minimum,
                   int maximum, const QString& suffix, const QString& minText);
    void addTheme(QFormLayout& form);
    void addShortcuts(QFormLayout& form);
    void addLanguage(QFormLayout& form);
    void addMouseScheme(QFormLayout& form);
    void addAtRest(QFormLayout& form);
    void addScale(QFormLayout& form);
    void addStillQuality(QFormLayout& form);
    void addDenoise(QFormLayout& form);
    void addSensitivity(QFormLayout& form);
    void askForBindings();
    void finish();
    void applyBindings();

    Preferences& preferences_;
    Session& session_;
    QList<std::function<void()>> stores_; ///< each writes one field to the preferences
    KeyBindingsPage* keys_;
    QPushButton* ok_ = nullptr;
    QList<Binding> present_; ///< current ones of the server, or of the preferences
};

} // namespace gui
