/// The page in the viewport while there is no server: scenes to open, and how to walk.
#pragma once

#include "gui/models/example_scenes.h"

#include <QStringList>
#include <QWidget>

class QVBoxLayout;

namespace gui {

class StartPage : public QWidget {
    Q_OBJECT

  public:
    StartPage(const QList<ExampleScene>& examples, const QStringList& recent, QWidget* parent = nullptr);

    void setRecent(const QStringList& files); ///< the newest first; the first few are shown

  signals:
    void openWanted(const QString& path);
    void chooseWanted(); ///< any other file
    void connectWanted();

  private:
    void addScene(QVBoxLayout& column, const QString& text, const QString& path);

    QWidget* recentPart_;
    QVBoxLayout* recent_;
};

} // namespace gui
