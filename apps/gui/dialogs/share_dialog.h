/// Sharing a server in web pages: what is chosen before, then the links. It starts nothing itself.
#pragma once

#include "gui/dialogs/share_links_page.h"
#include "gui/dialogs/share_plan_page.h"

#include <QDialog>

class QPushButton;
class QStackedWidget;

namespace gui {

class ShareDialog : public QDialog {
    Q_OBJECT

  public:
    /// Begins with the choice.
    ShareDialog(Preferences& preferences, const QList<OwnAddress>& addresses, QWidget* parent = nullptr);

    void showPlan(const QString& trouble); ///< `trouble`: why it is not shared; may be empty
    void showStarting();
    void showLinks(const BridgeRequest& request, const BridgeLinks& links);
    ShareLinksPage& links() { return *links_; }

  signals:
    void startWanted(const gui::BridgeRequest& request); ///< without the server's name
    void stopWanted();

  protected:
    bool event(QEvent* event) override;

  private:
    enum class Stage { Plan, Starting, Links };
    void become(Stage stage);
    void start();

    QStackedWidget* pages_;
    SharePlanPage* plan_;
    ShareLinksPage* links_;
    QPushButton* start_;
    QPushButton* stop_;
    QPushButton* close_;
};

} // namespace gui
