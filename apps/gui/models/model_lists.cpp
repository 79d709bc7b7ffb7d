#include "gui/models/model_lists.h"

#include "rtcore/io/text/scn.h"
#include "rtcore/platform/error.h"

#include <QColor>

#include <vector>

namespace gui {

namespace {

constexpr int kMaxSide = 4096;

/// So many words of a line, and what follows them.
struct Line {
    QStringList words;
    QString rest;
};

Line splitLine(const QString& line, int words) {
    Line out;
    qsizetype at = 0;
    for (int i = 0; i < words; ++i) {
        const qsizetype end = line.indexOf(QLatin1Char(' '), at);
        out.words.append(line.mid(at, end < 0 ? -1 : end - at));
        if (end < 0) return out;
        at = end + 1;
    }
    out.rest = line.mid(at);
    return out;
}

std::array<float, 3> arrayOf(const std::optional<rtcore::Colour>& colour) {
    return colour ? std::array{colour->r, colour->g, colour->b} : std::array<float, 3>{};
}

std::vector<bool> readRuns(const QStringList& words, std::size_t pixels) {
    std::vector<bool> mask;
    bool inside = false;
    for (qsizetype i = 2; i < words.size(); ++i, inside = !inside) {
        const auto run = static_cast<std::size_t>(words[i].toUInt());
        if (run > pixels - mask.size()) return {};
        mask.insert(mask.end(), run, inside);
    }
    return mask.size() == pixels ? mask : std::vector<bool>();
}

} // namespace

QList<PartRow> readParts(const QString& answer) {
    QList<PartRow> rows;
    for (const QString& text : answer.split(QLatin1Char('\n'), Qt::SkipEmptyParts)) {
        const Line line = splitLine(text, 3);
        if (line.words.size() < 3 || line.words[0].toInt() < 1) continue;
        const bool hidden = line.words[1] == QLatin1String("hidden");
        rows.append({line.words[0].toInt(), hidden, line.words[2].toLongLong(), line.rest});
    }
    return rows;
}

QList<MaterialRow> readMaterials(const QString& answer) {
    QList<MaterialRow> rows;
    for (const QString& text : answer.split(QLatin1Char('\n'), Qt::SkipEmptyParts)) {
        const Line line = splitLine(text, 2);
        if (line.words.size() < 2 || line.words[0].toInt() < 1) continue;
        rows.append({line.words[0].toInt(), line.words[1] == QLatin1String("edited"), line.rest});
    }
    return rows;
}

std::optional<MaterialState> readMaterialState(const QString& answer) {
    try {
        // A name may be missing, and says nothing here.
        QString text = answer;
        text.replace(QLatin1String("name = \"\""), QLatin1String("name = \"*\""));
        const rtcore::SceneFile file =
            rtcore::parseSceneFile("version = 2\nmodel = \"m\"\n" + text.toStdString() + '\n', "material");
        if (file.materials.size() != 1) return std::nullopt;
        const rtcore::MaterialOverride& m = file.materials.front();
        MaterialState state;
        state.diffuse = arrayOf(m.diffuse);
        state.transmission = arrayOf(m.transmission);
        state.roughness = m.roughness.value_or(state.roughness);
        state.metallic = m.metallic.value_or(state.metallic);
        state.reflectivity = m.reflectivity ? maxComponent(*m.reflectivity) : 0;
        state.opacity = m.opacity.value_or(state.opacity);
        state.indexOfRefraction = m.indexOfRefraction.value_or(state.indexOfRefraction);
        state.priority = m.priority.value_or(state.priority);
        state.coat = m.coat.value_or(state.coat);
        state.coatRoughness = m.coatRoughness.value_or(state.coatRoughness);
        state.textures = m.textures;
        state.flipTextures = m.flipTextures.value_or(false);
        return state;
    } catch (const rtcore::FileError&) {
        return std::nullopt;
    }
}

std::optional<SeenRow> readSeen(const QString& answer) {
    const QStringList lines = answer.split(QLatin1Char('\n'));
    if (lines.size() != 2) return std::nullopt;
    const Line part = splitLine(lines[0], 2), material = splitLine(lines[1], 2);
    if (part.words.size() < 2 || material.words.size() < 2) return std::nullopt;
    return SeenRow{part.words[1].toInt(), material.words[1].toInt()};
}

QImage readMark(const QString& answer, const QColor& colour) {
    const QStringList words = answer.split(QLatin1Char(' '));
    const int width = words.value(0).toInt(), height = words.value(1).toInt();
    if (width < 1 || height < 1 || width > kMaxSide || height > kMaxSide) return {};
    const auto columns = static_cast<std::size_t>(width);
    const std::vector<bool> mask = readRuns(words, columns * static_cast<std::size_t>(height));
    if (mask.empty()) return {};
    const auto inside = [&](int x, int y) {
        return x >= 0 && y >= 0 && x < width && y < height &&
               mask[static_cast<std::size_t>(y) * columns + static_cast<std::size_t>(x)];
    };
    QImage mark(width, height, QImage::Format_ARGB32_Premultiplied);
    mark.fill(Qt::transparent);
    QColor veil = colour;
    veil.setAlphaF(0.18F);
    bool any = false;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            if (!inside(x, y)) continue;
            any = true;
            const bool edge =
                !inside(x - 1, y) || !inside(x + 1, y) || !inside(x, y - 1) || !inside(x, y + 1);
            mark.setPixelColor(x, y, edge ? colour : veil);
        }
    }
    return any ? mark : QImage();
}

} // namespace gui
