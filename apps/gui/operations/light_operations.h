/// Lights: their panel, their marks in the image, and what both change.
#pragma once

#include "gui/operations/gui_context.h"

#include <QObject>

#include <optional>
#include <string>

namespace gui {

class LightHandles;
class LightsPanel;
struct Answer;

class LightOperations : public QObject {
    Q_OBJECT

  public:
    LightOperations(const GuiContext& context, QObject* parent);

  private:
    void connectPanel();
    void showSky();
    void connectHandles();
    void showState();
    void turn(int id, const QVector3D& towards, bool goesOn);
    void select(int id);
    void follow(const QString& step, const std::string& line, std::optional<bool> goesOn);
    void add(const std::string& line);

    GuiContext context_;
    LightsPanel* panel_;
    LightHandles* handles_;
    int added_ = 0; ///< selected as soon as the server tells of it
};

} // namespace gui
