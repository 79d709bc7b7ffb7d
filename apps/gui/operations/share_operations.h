/// Sharing the server in web pages: from the action to the bridge and its end.
#pragma once

#include "gui/operations/gui_context.h"
#include "gui/processes/bridge_process.h"
#include "gui/processes/bridge_watch.h"
#include "gui/processes/link_opener.h"

#include <QObject>
#include <QPointer>

namespace gui {

class ShareDialog;

/// It ends when the window leaves the server, and when that ends, unless the window may start it again.
class ShareOperations : public QObject {
    Q_OBJECT

  public:
    ShareOperations(const GuiContext& context, QObject* parent);

    const BridgeProcess& bridge() const { return bridge_; }

  private:
    void showDialog();
    void fillDialog();
    void start(BridgeRequest request);
    void open(const QString& link);
    void onLinks();
    void onEnded(const QString& text);
    void onState();
    void showState();
    bool serverStays() const;

    GuiContext context_;
    BridgeProcess bridge_;
    BridgeWatch watch_;
    LinkOpener opener_;
    QPointer<ShareDialog> dialog_;
};

} // namespace gui
