#include "rtcore/io/import/assimp/collada_morphs.h"

#include "rtcore/io/import/assimp/xml_text.h"
#include "rtcore/platform/files.h"
#include "rtcore/settings/number_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace rtcore {

namespace {

using Text = std::string_view;
using xml::attributeOf;
using xml::idOf;
using xml::takeElement;

struct Edit {
    Text place; ///< in the text of the file
    std::string text;
};

struct Morph {
    std::string controller, geometry;
    bool relative = false;
    std::vector<std::string> targets;
    std::string weightList; ///< its source
    std::vector<float> weights;
};

/// What a channel animates: "list(index)".
struct WeightTarget {
    static constexpr std::size_t kNone = Text::npos;
    Text list;
    std::size_t index = 0; ///< kNone: it says none that is a number
};

/// The node whose place is the weight of a target, both by number.
std::string weightNode(std::size_t morph, std::size_t target) {
    return std::string(kWeightNode) + std::to_string(morph) + "-" + std::to_string(target);
}

/// Without an index the first one; behind the last slash, where the controller is named, too.
WeightTarget weightTargetOf(Text target) {
    target.remove_prefix(target.rfind('/') + 1);
    const std::size_t bracket = std::min(target.find('('), target.size());
    WeightTarget result{target.substr(0, bracket), 0};
    if (bracket == target.size()) return result;
    const char *const begin = target.data() + bracket + 1, *const end = target.data() + target.size();
    if (std::from_chars(begin, end, result.index).ec != std::errc()) result.index = WeightTarget::kNone;
    return result;
}

/// Up to the first word that is none.
std::vector<float> floatsIn(Text text) {
    std::vector<float> numbers;
    for (;;) {
        const std::size_t at = text.find_first_not_of(" \t\r\n");
        if (at == Text::npos) return numbers;
        text.remove_prefix(at);
        float number = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
        if (error != std::errc()) return numbers;
        numbers.push_back(number);
        text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    }
}

std::vector<std::string> wordsIn(Text text) {
    std::vector<std::string> words;
    for (;;) {
        const std::size_t at = text.find_first_not_of(" \t\r\n");
        if (at == Text::npos) return words;
        text.remove_prefix(at);
        const std::size_t end = std::min(text.find_first_of(" \t\r\n"), text.size());
        words.emplace_back(text.substr(0, end));
        text.remove_prefix(end);
    }
}

/// The source that an input of this meaning names; "" where there is none.
std::string sourceOf(Text inputs, Text semantic) {
    while (const auto input = takeElement(inputs, "input"))
        if (attributeOf(input->head, "semantic") == semantic) return idOf(attributeOf(input->head, "source"));
    return {};
}

/// The content of the list of a source.
Text listOf(Text sources, const std::string& id, const char* list) {
    while (const auto source = takeElement(sources, "source")) {
        if (id.empty() || attributeOf(source->head, "id") != id) continue;
        Text body = source->body;
        const auto found = takeElement(body, list);
        return found ? found->body : Text();
    }
    return {};
}

Morph morphOf(const std::string& controller, const xml::Element& morph) {
    Morph result{controller, idOf(attributeOf(morph.head, "source")), false, {}, {}, {}};
    result.relative = attributeOf(morph.head, "method") == "RELATIVE";
    const std::string targets = sourceOf(morph.body, "MORPH_TARGET");
    Text names = listOf(morph.body, targets, "IDREF_array");
    if (names.empty()) names = listOf(morph.body, targets, "Name_array");
    result.targets = wordsIn(names);
    result.weightList = sourceOf(morph.body, "MORPH_WEIGHT");
    result.weights = floatsIn(listOf(morph.body, result.weightList, "float_array"));
    return result;
}

/// Takes the place of the controllers, whatever refers to one then refers to its geometry.
class MorphEditor {
  public:
    explicit MorphEditor(Text text) : text_(text) {}

    /// False where there are none.
    bool find() {
        Text rest = text_;
        while (const auto controller = takeElement(rest, "controller")) {
            Text body = controller->body;
            const auto morph = takeElement(body, "morph");
            if (!morph) continue;
            morphs_.push_back(morphOf(attributeOf(controller->head, "id"), *morph));
            remove(*controller);
        }
        return !morphs_.empty();
    }

    std::string edited(const ColladaWeights& weights) {
        findGeometries();
        moveChannels();
        setWeights(weights);
        for (const Morph& morph : morphs_) {
            move(morph, "POSITION");
            move(morph, "NORMAL");
        }
        replaceUses();
        return applied();
    }

  private:
    const Morph* morphNamed(const std::string& controller) const {
        const auto found = std::ranges::find(morphs_, controller, &Morph::controller);
        return found != morphs_.end() ? &*found : nullptr;
    }

    /// From its head to its end.
    void remove(const xml::Element& element) {
        const char* const behind = element.body.data() + element.body.size();
        edits_.push_back({Text(element.head.data(), static_cast<std::size_t>(behind - element.head.data())),
                          "<controller>"});
    }

    /// Assimp would move the nodes of the meshes by these channels.
    void moveChannels() {
        std::map<Text, std::size_t> morphOfList; // the first one
        for (std::size_t m = 0; m < morphs_.size(); ++m) morphOfList.try_emplace(morphs_[m].weightList, m);
        std::set<std::pair<std::size_t, std::size_t>> moved; // morphs and targets
        Text rest = text_;
        while (const auto channel = takeElement(rest, "channel")) {
            const Text target = xml::valueOf(*channel, "target");
            const WeightTarget weight = weightTargetOf(target);
            const auto found = morphOfList.find(weight.list);
            if (weight.list.empty() || found == morphOfList.end()) continue;
            const bool known = weight.index < morphs_[found->second].weights.size();
            if (known) moved.emplace(found->second, weight.index);
            const std::string node =
                known ? weightNode(found->second, weight.index) : std::string(kWeightNode);
            edits_.push_back({target, node + "/t.X"}); // of the last one there is no node
        }
        std::string nodes;
        for (const auto& [m, t] : moved)
            nodes += "<node id=\"" + weightNode(m, t) + "\" name=\"" + weightNode(m, t) +
                     "\"><translate sid=\"t\">" + shortestText(morphs_[m].weights[t]) +
                     " 0 0</translate></node>";
        addToScene(nodes);
    }

    /// At the end of the scene that is shown.
    void addToScene(const std::string& nodes) {
        Text rest = text_;
        const auto shown = takeElement(rest, "instance_visual_scene");
        if (nodes.empty() || !shown) return;
        const std::string id = idOf(attributeOf(shown->head, "url"));
        rest = text_;
        while (const auto scene = takeElement(rest, "visual_scene"))
            if (attributeOf(scene->head, "id") == id)
                return edits_.push_back({scene->body.substr(scene->body.size()), nodes});
    }

    void setWeights(const ColladaWeights& weights) {
        for (std::size_t m = 0; m < morphs_.size() && !weights.empty(); ++m) {
            for (std::size_t t = 0; t < morphs_[m].weights.size(); ++t) {
                const auto weight = weights.find(weightNode(m, t));
                if (weight != weights.end()) morphs_[m].weights[t] = weight->second;
            }
        }
    }

    void findGeometries() {
        Text rest = text_;
        while (const auto geometry = takeElement(rest, "geometry"))
            geometries_[attributeOf(geometry->head, "id")] = geometry->body;
    }

    /// The numbers of positions or normals; positions are named by the list of vertices.
    Text numbersOf(const std::string& geometry, Text semantic) const {
        const auto found = geometries_.find(geometry);
        if (found == geometries_.end()) return {};
        return listOf(found->second, sourceOf(found->second, semantic), "float_array");
    }

    void move(const Morph& morph, Text semantic) {
        const Text place = numbersOf(morph.geometry, semantic);
        if (place.empty() || !moved_.insert(place.data()).second) return;
        const std::vector<float> base = floatsIn(place);
        std::vector<float> sum = base;
        bool moves = false;
        for (std::size_t t = 0; t < std::min(morph.targets.size(), morph.weights.size()); ++t) {
            const float weight = morph.weights[t];
            if (weight == 0 || !std::isfinite(weight)) continue;
            const std::vector<float> target = floatsIn(numbersOf(morph.targets[t], semantic));
            if (target.size() != sum.size()) continue;
            moves = true;
            for (std::size_t i = 0; i < sum.size(); ++i)
                sum[i] += weight * (target[i] - (morph.relative ? 0 : base[i]));
        }
        if (!moves) return;
        std::string text;
        for (const float v : sum) text += shortestText(v) + " ";
        edits_.push_back({place, std::move(text)});
    }

    void replaceUses() {
        Text rest = text_;
        while (const auto use = takeElement(rest, "instance_controller")) {
            const Morph* const morph = morphNamed(idOf(attributeOf(use->head, "url")));
            if (morph == nullptr) continue;
            edits_.push_back({use->head, "<instance_geometry url=\"#" + morph->geometry + "\"" +
                                             (use->head.ends_with('/') ? "/" : "")});
            if (use->head.ends_with('/')) continue;
            constexpr Text kEnd = "</instance_controller";
            edits_.push_back({Text(use->body.data() + use->body.size(), kEnd.size()), "</instance_geometry"});
        }
        rest = text_;
        while (const auto skin = takeElement(rest, "skin")) {
            const Morph* const morph = morphNamed(idOf(attributeOf(skin->head, "source")));
            if (morph != nullptr) edits_.push_back({skin->head, "<skin source=\"#" + morph->geometry + "\""});
        }
    }

    std::string applied() {
        std::ranges::sort(edits_, {}, [](const Edit& edit) { return edit.place.data(); });
        std::string result;
        const char* at = text_.data();
        const char* const end = text_.data() + text_.size();
        for (const Edit& edit : edits_) {
            if (edit.place.data() < at || edit.place.data() + edit.place.size() > end) continue; // damaged
            result.append(at, edit.place.data());
            result += edit.text;
            at = edit.place.data() + edit.place.size();
        }
        return result.append(at, end);
    }

    Text text_;
    std::vector<Morph> morphs_;
    std::map<std::string, Text> geometries_;
    std::set<const char*> moved_; ///< lists, by where they begin
    std::vector<Edit> edits_;
};

bool mentionsMorphs(const std::filesystem::path& path) {
    const FileBytes file = openFileBytes(path);
    const Text text(reinterpret_cast<const char*>(file.bytes.data()), file.bytes.size());
    return text.find("<morph") != Text::npos;
}

} // namespace

std::optional<std::string> colladaWithoutMorphs(const std::filesystem::path& path,
                                                const ColladaWeights& weights) {
    if (!xml::isCollada(path)) return std::nullopt;
    if (!mentionsMorphs(path)) return std::nullopt;
    const std::string text = xml::textWithoutComments(path);
    MorphEditor editor(text);
    if (!editor.find()) return std::nullopt;
    return editor.edited(weights);
}

} // namespace rtcore
