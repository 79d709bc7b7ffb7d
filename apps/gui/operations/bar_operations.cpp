#include "gui/operations/bar_operations.h"

#include "gui/models/plain_text.h"
#include "gui/operations/actions.h"
#include "gui/view/symbol_icon.h"

#include <QAction>
#include <QEvent>
#include <QMainWindow>
#include <QMenu>
#include <QToolBar>
#include <QToolButton>

namespace gui {

BarOperations::BarOperations(const GuiContext& context, QObject* parent)
    : QObject(parent), context_(context), bar_(new QToolBar(tr("Tool bar"))) {
    constexpr int kSide = 20;
    bar_->setObjectName(QStringLiteral("bar")); // restoreState() knows it by this
    bar_->setMovable(false);
    bar_->setIconSize({kSide, kSide});
    bar_->setContextMenuPolicy(Qt::PreventContextMenu);
    if (auto* window = qobject_cast<QMainWindow*>(&context_.window)) window->addToolBar(bar_);
    add(ActionId::Undo, "undo");
    add(ActionId::Redo, "redo");
    bar_->addSeparator();
    add(ActionId::Orbit, "orbit");
    add(ActionId::Walk, "walk");
    add(ActionId::Fly, "fly");
    add(ActionId::FitView, "fit");
    bar_->addSeparator();
    addLight();
    add(ActionId::SettingsPanel, "settings");
    bar_->addSeparator();
    add(ActionId::ShareInBrowser, "share");
    // The keys stay the camera's; all of it is in the menus, too.
    for (QToolButton* button : bar_->findChildren<QToolButton*>()) button->setFocusPolicy(Qt::NoFocus);
    context_.actions.onToggle(ActionId::ShowBar, [this](bool on) { bar_->setVisible(on); });
    context_.actions[ActionId::ShowBar]->setChecked(true);
    bar_->installEventFilter(this);
}

// By whatever it is hidden: the menu, a full screen, what the last window was like.
bool BarOperations::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::ShowToParent || event->type() == QEvent::HideToParent)
        context_.actions[ActionId::ShowBar]->setChecked(!bar_->isHidden());
    return QObject::eventFilter(watched, event);
}

void BarOperations::add(ActionId id, const char* symbol) {
    QAction* action = context_.actions[id];
    action->setIcon(symbolIcon(QString::fromLatin1(symbol)));
    action->setIconVisibleInMenu(false);
    bar_->addAction(action);
}

void BarOperations::addLight() {
    auto* button = new QToolButton;
    button->setIcon(symbolIcon(QStringLiteral("lights")));
    button->setToolTip(plainTip(tr("Light the scene anew")));
    button->setAccessibleName(tr("Light"));
    button->setPopupMode(QToolButton::InstantPopup);
    auto* looks = new QMenu(button);
    for (const ActionId id : {ActionId::LookSky, ActionId::LookStudio, ActionId::LookHeadlight})
        looks->addAction(context_.actions[id]);
    looks->addSeparator();
    if (QMenu* skies = context_.actions.skies()) looks->addMenu(skies);
    for (const ActionId id : {ActionId::OpenEnvironment, ActionId::NoEnvironment})
        looks->addAction(context_.actions[id]);
    button->setMenu(looks);
    const QAction* look = context_.actions[ActionId::LookSky];
    const auto enable = [button, look] { button->setEnabled(look->isEnabled()); };
    connect(look, &QAction::changed, button, enable);
    enable();
    bar_->addWidget(button);
}

} // namespace gui
