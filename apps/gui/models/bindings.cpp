#include "gui/models/bindings.h"

#include "common/commands/command_lines.h"

#include "rtcore/motion/key_bindings.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <array>

namespace gui {

namespace {

// In the order of rtcore::Action.
constexpr std::array kTitles{
    QT_TRANSLATE_NOOP("Bindings", "Forward"),
    QT_TRANSLATE_NOOP("Bindings", "Back"),
    QT_TRANSLATE_NOOP("Bindings", "Left"),
    QT_TRANSLATE_NOOP("Bindings", "Right"),
    QT_TRANSLATE_NOOP("Bindings", "Up"),
    QT_TRANSLATE_NOOP("Bindings", "Down"),
    QT_TRANSLATE_NOOP("Bindings", "Turn left"),
    QT_TRANSLATE_NOOP("Bindings", "Turn right"),
    QT_TRANSLATE_NOOP("Bindings", "Look up"),
    QT_TRANSLATE_NOOP("Bindings", "Look down"),
    QT_TRANSLATE_NOOP("Bindings", "Jump"),
    QT_TRANSLATE_NOOP("Bindings", "Crouch"),
    QT_TRANSLATE_NOOP("Bindings", "Crawl"),
    QT_TRANSLATE_NOOP("Bindings", "Sprint"),
    QT_TRANSLATE_NOOP("Bindings", "Walk or fly"),
    QT_TRANSLATE_NOOP("Bindings", "Bloom on or off"),
    QT_TRANSLATE_NOOP("Bindings", "Light on or off"),
    QT_TRANSLATE_NOOP("Bindings", "Environment map"),
};
static_assert(kTitles.size() == rtcore::kActions);

QString text(std::string_view view) {
    return QString::fromUtf8(view.data(), static_cast<qsizetype>(view.size()));
}

std::optional<rtcore::Action> actionOf(const QString& name) {
    return rtcore::actionNamed(name.toStdString());
}

} // namespace

QList<Binding> defaultBindings() {
    QList<Binding> bindings;
    for (const rtcore::KeyBinding& each : rtcore::defaultKeyBindings()) {
        QString keys = QString::fromStdString(rtcore::keyName(each.key));
        if (each.with != rtcore::KeyNone)
            keys.prepend(QString::fromStdString(rtcore::keyName(each.with)) + QLatin1Char('+'));
        bindings.append({keys, text(rtcore::actionName(each.action)), each.number});
    }
    return bindings;
}

QList<Binding> readBindings(const QString& text) {
    QList<Binding> bindings;
    for (const QString& line : text.split(QLatin1Char('\n'), Qt::SkipEmptyParts)) {
        const QStringList words = line.simplified().split(QLatin1Char(' '));
        if (words.size() < 2 || words.size() > 3) continue;
        const std::optional<QString> keys = normalKeys(words[0]);
        if (keys && actionOf(words[1])) bindings.append({*keys, words[1], words.value(2).toInt()});
    }
    return bindings;
}

// A plus sign can be a key itself.
QStringList keyNames(const QString& keys) {
    const qsizetype plus = keys.indexOf(QLatin1Char('+'), 1);
    return plus < 0 ? QStringList{keys} : QStringList{keys.left(plus), keys.mid(plus + 1)};
}

std::optional<QString> normalKeys(const QString& keys) {
    QStringList normal;
    for (const QString& name : keyNames(keys)) {
        const std::optional<int> code = rtcore::keyNamed(name.trimmed().toStdString());
        if (!code) return std::nullopt;
        normal.append(QString::fromStdString(rtcore::keyName(*code)));
    }
    return normal.join(QLatin1Char('+'));
}

QStringList bindableActions() {
    QStringList names;
    for (std::size_t i = 0; i < rtcore::kActions; ++i)
        names.append(text(rtcore::actionName(static_cast<rtcore::Action>(i))));
    return names;
}

QString actionTitle(const QString& action) {
    const std::optional<rtcore::Action> known = actionOf(action);
    if (!known) return action;
    return QCoreApplication::translate("Bindings", kTitles[static_cast<std::size_t>(*known)]);
}

bool takesNumber(const QString& action) {
    const std::optional<rtcore::Action> known = actionOf(action);
    return known && rtcore::hasNumber(*known);
}

std::string bindCommand(const Binding& binding) {
    const std::string keys = binding.keys.toStdString(), action = binding.action.toStdString();
    return takesNumber(binding.action) ? app::command::bind(keys, action, binding.number)
                                       : app::command::bind(keys, action);
}

std::string unbindCommand(const QString& keys) { return app::command::unbind(keys.toStdString()); }

std::vector<std::string> bindingChanges(const QList<Binding>& present, const QList<Binding>& wanted) {
    std::vector<std::string> commands;
    for (const Binding& each : present) {
        const bool kept = std::any_of(wanted.begin(), wanted.end(),
                                      [&](const Binding& other) { return other.keys == each.keys; });
        if (!kept) commands.push_back(unbindCommand(each.keys));
    }
    for (const Binding& each : wanted) {
        if (!present.contains(each)) commands.push_back(bindCommand(each));
    }
    return commands;
}

} // namespace gui
