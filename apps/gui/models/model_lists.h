/// Readers of the server's answers about the model's parts and materials (the commands parts, materials,
/// material get, seen and mask).
#pragma once

#include <QImage>
#include <QList>
#include <QString>

#include <array>
#include <optional>

namespace gui {

struct PartRow {
    int number = 0; ///< from 1
    bool hidden = false;
    qint64 triangles = 0;
    QString name; ///< with slashes; may be empty
    friend bool operator==(const PartRow&, const PartRow&) = default;
};

struct MaterialRow {
    int number = 0; ///< from 1
    bool edited = false;
    QString name; ///< may be empty
    friend bool operator==(const MaterialRow&, const MaterialRow&) = default;
};

/// As the keys of a [[material]] have it.
struct MaterialState {
    std::array<float, 3> diffuse{}, transmission{}; ///< linear
    float roughness = 1, metallic = 0, reflectivity = 0, opacity = 1, indexOfRefraction = 1.5F;
    float priority = 0, coat = 0, coatRoughness = 0;
    std::optional<bool> textures; ///< nothing: it has none
    bool flipTextures = false;
    friend bool operator==(const MaterialState&, const MaterialState&) = default;
};

struct SeenRow {
    int part = 0; ///< 0: none
    int material = 0;
};

/// Lines that are none are left out.
QList<PartRow> readParts(const QString& answer);
QList<MaterialRow> readMaterials(const QString& answer);
std::optional<MaterialState> readMaterialState(const QString& answer);
std::optional<SeenRow> readSeen(const QString& answer);
/// An outline in `colour` around a mask, with a veil of it inside; null when the answer is none, or empty.
QImage readMark(const QString& answer, const QColor& colour);

} // namespace gui
