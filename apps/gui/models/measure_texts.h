/// Kept measures as the window tells them.
#pragma once

#include "gui/models/scene_state.h"

#include <QList>
#include <QString>

namespace gui {

/// "2.350 m", "24.5 m²", "90.0°", as the user's language writes numbers.
QString measureText(const rtcore::MeasureValue& value, rtcore::LengthUnit unit);
/// A row of the list: "2  Distance 2.350 m" and the name, where there is one.
QString measureRow(const SceneState& state, int index);
/// "Distance".
QString measureKindText(rtcore::MeasureKind kind);
/// Without the digits of its rounding to a float.
double metresPerUnitOf(const SceneState& state);

/// A text at a point of the scene.
struct MeasureLabel {
    rtcore::Vec3d point;
    QString text;
    bool below = false; ///< the point, so that it leaves room for another label
};
/// That of the whole, with its name, then those of the legs of a chain.
QList<MeasureLabel> labelsOf(const rtcore::KeptMeasure& measure, const SceneState& state);

} // namespace gui
