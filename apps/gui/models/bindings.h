/// Which key does what on the server, as its command `bindings` prints it: KEY[+KEY] ACTION [NUMBER].
#pragma once

#include <QList>
#include <QString>

#include <optional>
#include <string>
#include <vector>

namespace gui {

struct Binding {
    QString keys;   ///< "W", "M+3": the second one acts while the first one is down
    QString action; ///< "forward"
    int number = 0; ///< of the light or environment; 0 = none
    friend bool operator==(const Binding&, const Binding&) = default;
};

/// The built-in ones.
QList<Binding> defaultBindings();
/// Lines that are none are left out.
QList<Binding> readBindings(const QString& text);

/// The one or two names in "W", "M+3", "M++".
QStringList keyNames(const QString& keys);
/// "M+3" with both names as the server spells them; nothing when one is no key.
std::optional<QString> normalKeys(const QString& keys);

/// All actions that a key can have; actionTitle() translates them.
QStringList bindableActions();
QString actionTitle(const QString& action);
/// True for actions with the number of a light or an environment.
bool takesNumber(const QString& action);

/// Commands for the server.
std::string bindCommand(const Binding& binding);
std::string unbindCommand(const QString& keys);
/// The commands that make `wanted` of `present`.
std::vector<std::string> bindingChanges(const QList<Binding>& present, const QList<Binding>& wanted);

} // namespace gui
