#include "rtcore/io/import/assimp/x3d_text.h"

#include "rtcore/io/import/materials/model_folder.h"
#include "rtcore/io/import/materials/texture_files.h"
#include "rtcore/io/import/text/statement_text.h"
#include "rtcore/platform/error.h"
#include "rtcore/platform/files.h"
#include "rtcore/platform/sentence.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <string_view>
#include <system_error>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace rtcore {

namespace {

using View = std::string_view;
using xml::attributeOf;
using xml::kNoNode;
using xml::Node;

constexpr std::size_t kMegabyte = 1024 * 1024;
constexpr std::size_t kMaxCopies = 64; // in MB
constexpr int kDeepest = 500;          // which no author nests

constexpr std::array<View, 2> kKeptGroups{"Transform", "Switch"};
constexpr std::array<View, 6> kPlainGroups{"Group", "StaticGroup", "Anchor", "Billboard", "Collision", "LOD"};
constexpr std::array<View, 5> kOtherChildren{"Shape", "Inline", "DirectionalLight", "PointLight",
                                             "SpotLight"};

/// Passed over by Assimp; without content it takes a group for one that has none.
constexpr View kFiller = "<WorldInfo/>", kFilledGroup = "<Group><WorldInfo/></Group>";

bool isOneOf(std::span<const View> names, View name) { return std::ranges::find(names, name) != names.end(); }

bool isGroup(View name) { return isOneOf(kKeptGroups, name) || isOneOf(kPlainGroups, name); }

[[noreturn]] void refuseX3d(const Sentence& sentence) { throw FileError(FailureKind::BadData, "", sentence); }

std::string replaced(View text, View from, View to) {
    std::string result;
    for (std::size_t at = text.find(from); at != View::npos; at = text.find(from)) {
        result.append(text.substr(0, at)).append(to);
        text.remove_prefix(at + from.size());
    }
    return result.append(text);
}

/// The first strings of a list, which stand in quotes; a text without any is one.
std::vector<std::string> stringsOf(View value) {
    constexpr std::size_t kMaxStrings = 64; // each is looked for
    const std::string text = replaced(value, "&quot;", "\"");
    if (text.find('"') == std::string::npos) return {text};
    std::vector<std::string> strings;
    for (std::size_t open = text.find('"'); open != std::string::npos && strings.size() < kMaxStrings;) {
        const std::size_t close = text.find('"', open + 1);
        if (close == std::string::npos) break;
        strings.push_back(text.substr(open + 1, close - open - 1));
        open = text.find('"', close + 1);
    }
    return strings;
}

std::string withoutEntities(std::string text) {
    constexpr std::array<std::pair<View, View>, 4> kEntities{
        {{"&apos;", "'"}, {"&lt;", "<"}, {"&gt;", ">"}, {"&amp;", "&"}}};
    for (const auto& [entity, character] : kEntities) text = replaced(text, entity, character);
    return text;
}

std::filesystem::path x3dFile(const std::filesystem::path& folder, const std::string& name) {
    return folder / withoutEntities(name);
}

/// Nothing where none of them is there, or may be read.
std::optional<std::string> inlined(const ModelFolder& home, const std::filesystem::path& folder, View list) {
    const std::vector<std::string> names = stringsOf(list);
    const auto file = std::ranges::find_if(names, [&](const std::string& name) {
        std::error_code error;
        const std::filesystem::path path = x3dFile(folder, name);
        return std::filesystem::is_regular_file(path, error) && home.holds(path);
    });
    return file != names.end() ? std::optional(*file) : std::nullopt;
}

/// Writes the elements of a document anew.
class X3dWriter {
  public:
    X3dWriter(std::span<const Node> nodes, const std::filesystem::path& path, std::size_t maxLength)
        : nodes_(nodes), folder_(path.parent_path()), home_(path), maxLength_(maxLength),
          isOpen_(nodes.size(), 0) {}

    /// Nothing where all of it may stay.
    std::optional<std::string> written() {
        write(0);
        if (!changed_) return std::nullopt;
        return std::move(text_);
    }

  private:
    void write(std::uint32_t number) {
        const View name = nodes_[number].name;
        if (text_.size() > maxLength_)
            refuseX3d(say("the groups that it uses again (USE) come to more than {0} MB of text; export it "
                          "with fewer of them",
                          kMaxCopies));
        if (++depth_ > kDeepest)
            refuseX3d(say("its elements are nested more than {0} deep; export it again", kDeepest));
        if (name == "ProtoDeclare") {
            text_ += kFiller; // names in it are not those of the scene
        } else if (isGroup(name)) {
            writeGroup(number);
        } else if (name == "Shape") {
            writeShape(number);
        } else if (name == "Inline" && isLeftOut(number)) {
            text_ += kFilledGroup;
            changed_ = true;
        } else {
            const View own = attributeOf(nodes_[number], "DEF");
            if (name == "Cone" && !own.empty()) turnsOver_[own] = turnsOver(number);
            writeElement(number, name);
        }
        --depth_;
    }

    bool isLeftOut(std::uint32_t number) {
        const View use = attributeOf(nodes_[number], "USE"), own = attributeOf(nodes_[number], "DEF");
        if (!use.empty()) return leftOut_.contains(use);
        const bool isLost = !inlined(home_, folder_, attributeOf(nodes_[number], "url"));
        if (isLost && !own.empty()) leftOut_.insert(own);
        return isLost;
    }

    void writeGroup(std::uint32_t number) {
        const Node& node = nodes_[number];
        const View use = attributeOf(node, "USE"), own = attributeOf(node, "DEF");
        if (!use.empty()) {
            const auto target = groups_.find(use);
            if (target == groups_.end()) return writeElement(number, node.name); // which Assimp refuses
            changed_ = true;
            return write(target->second);
        }
        if (!own.empty()) groups_[own] = number;
        if (isOpen_[number] != 0)
            refuseX3d(say("its group {0} uses itself (USE); export it again", "'" + std::string(own) + "'"));
        isOpen_[number] = 1;
        const View name = isOneOf(kKeptGroups, node.name) ? node.name : "Group";
        changed_ = changed_ || name != node.name || node.firstChild == kNoNode;
        begin(node, name);
        if (node.firstChild == kNoNode) text_ += kFiller;
        writeChildren(node);
        end(name);
        isOpen_[number] = 0;
    }

    void writeChildren(const Node& group) {
        for (std::uint32_t child = group.firstChild; child != kNoNode; child = nodes_[child].nextSibling) {
            const Node& node = nodes_[child];
            const bool counts = isGroup(node.name) || isOneOf(kOtherChildren, node.name);
            if (group.name == "Collision" && attributeOf(node, "containerField") == "proxy") {
                text_ += kFiller;
            } else if (group.name == "Switch" && !counts) {
                // Assimp counts to whichChoice without those that it does not know, but with notes.
                if (!node.name.starts_with("Metadata")) text_ += kFilledGroup;
                changed_ = true;
            } else {
                write(child);
                if (group.name == "LOD" && counts) return;
            }
        }
    }

    /// Assimp's cones have their tip below, unless they are a base alone.
    bool turnsOver(std::uint32_t cone) const {
        const auto used = turnsOver_.find(attributeOf(nodes_[cone], "USE"));
        if (used != turnsOver_.end()) return used->second;
        return attributeOf(nodes_[cone], "side") != "false";
    }

    bool holdsTurnedCone(std::uint32_t shape) const {
        for (std::uint32_t child = nodes_[shape].firstChild; child != kNoNode;
             child = nodes_[child].nextSibling)
            if (nodes_[child].name == "Cone") return turnsOver(child);
        return false;
    }

    void writeShape(std::uint32_t number) {
        const View use = attributeOf(nodes_[number], "USE"), own = attributeOf(nodes_[number], "DEF");
        if (!own.empty()) shapes_[own] = number;
        const auto target = shapes_.find(use);
        const bool turns = holdsTurnedCone(target != shapes_.end() ? target->second : number);
        changed_ = changed_ || turns;
        if (turns) text_ += "<Transform scale='1 -1 -1'>"; // half a turn about x
        writeElement(number, "Shape");
        if (turns) end("Transform");
    }

    void writeElement(std::uint32_t number, View name) {
        const Node& node = nodes_[number];
        begin(node, name);
        for (std::uint32_t child = node.firstChild; child != kNoNode; child = nodes_[child].nextSibling)
            write(child);
        end(name);
    }

    void begin(const Node& node, View name) {
        text_ += '<';
        text_ += name;
        View rest = node.attributes;
        while (const auto attribute = xml::takeAttribute(rest)) {
            const bool isAddress =
                attribute->name == "url" && (node.name == "ImageTexture" || node.name == "Inline");
            const char quote = attribute->value.find('"') == View::npos ? '"' : '\'';
            text_ += ' ';
            text_ += attribute->name;
            text_ += '=';
            text_ += quote;
            text_ +=
                isAddress ? address(attribute->value, node.name == "Inline") : std::string(attribute->value);
            text_ += quote;
        }
        text_ += '>';
    }

    void end(View name) {
        text_ += "</";
        text_ += name;
        text_ += '>';
    }

    /// Assimp understands a list of one alone, without quotes and blanks.
    std::string address(View list, bool isInline) {
        const std::vector<std::string> strings = stringsOf(list);
        if (strings.empty()) return std::string(list);
        const auto there = std::ranges::find_if(strings, [&](const std::string& name) {
            return fileOfAnyCase(folder_, withoutEntities(name)).has_value();
        });
        const auto file = isInline ? inlined(home_, folder_, list) : std::nullopt;
        const std::string& first = there != strings.end() ? *there : strings.front();
        std::string chosen = replaced(file ? *file : first, " ", "%20");
        changed_ = changed_ || chosen != list;
        return chosen;
    }

    std::span<const Node> nodes_;
    std::filesystem::path folder_;
    ModelFolder home_;
    std::size_t maxLength_;
    std::vector<char> isOpen_; ///< of nodes
    std::unordered_map<View, std::uint32_t> groups_, shapes_;
    std::unordered_map<View, bool> turnsOver_; ///< cones
    std::unordered_set<View> leftOut_;         ///< of Inline
    std::string text_;
    int depth_ = 0;
    bool changed_ = false;
};

} // namespace

std::vector<std::string> x3dFilesLeftOut(std::span<const Node> nodes, const std::filesystem::path& path) {
    const ModelFolder home(path);
    std::vector<std::string> names;
    for (const Node& node : nodes) {
        const View list = attributeOf(node, "url");
        if (node.name != "Inline" || list.empty() || inlined(home, path.parent_path(), list)) continue;
        const std::vector<std::string> addresses = stringsOf(list);
        names.push_back(withoutEntities(addresses.empty() ? std::string(list) : addresses.front()));
    }
    return names;
}

bool isX3d(const std::filesystem::path& path) { return inSmallLetters(path.extension().string()) == ".x3d"; }

std::optional<std::string> x3dForAssimp(const std::filesystem::path& path) {
    if (!isX3d(path)) return std::nullopt;
    const FileBytes file = openFileBytes(path);
    const View text(reinterpret_cast<const char*>(file.bytes.data()), file.bytes.size());
    const auto nodes = xml::treeOf(text);
    if (!nodes) return std::nullopt;
    return X3dWriter(*nodes, path, 2 * text.size() + kMaxCopies * kMegabyte).written();
}

} // namespace rtcore
