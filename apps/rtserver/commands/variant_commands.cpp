// Commands for variants: sets of edits that are switched at once.
#include "rtserver/commands/command_call.h"
#include "rtserver/document/variant_edits.h"

#include "ipc/layout/limits.h"

#include "rtcore/io/text/scn.h"
#include "rtcore/platform/error.h"
#include "rtcore/platform/sentence.h"

#include <array>
#include <span>
#include <string>

namespace rtserver {

namespace {

Result listVariants(const Call& call) {
    const VariantBook& book = call.document().variants();
    std::string text;
    for (const rtcore::SceneVariant& each : book.all) {
        const std::string line = (each.name == book.active ? "on " : "off ") + each.name + '\n';
        if (text.size() + line.size() > ipc::kMaxAnswerText) break;
        text += line;
    }
    if (!text.empty()) text.pop_back();
    return {.answer = text};
}

Result tellVariant(const Call& call) {
    std::string text =
        rtcore::formatVariant(variantNamed(call.document(), call[0]), call.document().scene()->origin);
    if (text.size() > ipc::kMaxAnswerText)
        throw rtcore::Refusal(rtcore::say("the variant is too long for an answer; 'export scene' writes it"));
    return {.answer = std::move(text)};
}

Result add(const Call& call) {
    addVariant(call.document(), call[0]);
    return {};
}

Result update(const Call& call) {
    const std::string& active = call.document().variants().active;
    if (call.size() == 0 && active.empty())
        throw rtcore::Refusal("no variant is active; name the one to be updated");
    updateVariant(call.document(), call.size() > 0 ? call[0] : active);
    return {};
}

Result renameOne(const Call& call) {
    renameVariant(call.document(), call[0], call[1]);
    return {};
}

Result removeOne(const Call& call) {
    removeVariant(call.document(), call[0]);
    return {};
}

Result rebase(const Call& call) {
    rebaseVariants(call.document());
    return {};
}

Result go(const Call& call) {
    goToVariant(call.document(), call[0]);
    return {};
}

Result leave(const Call& call) {
    leaveVariant(call.document());
    return {};
}

constexpr std::array kVariantFunctions{
    CommandFunction{app::CommandId::VariantList, listVariants},
    CommandFunction{app::CommandId::VariantGet, tellVariant},
    CommandFunction{app::CommandId::VariantAdd, add},
    CommandFunction{app::CommandId::VariantUpdate, update},
    CommandFunction{app::CommandId::VariantRename, renameOne},
    CommandFunction{app::CommandId::VariantRemove, removeOne},
    CommandFunction{app::CommandId::VariantRebase, rebase},
    CommandFunction{app::CommandId::VariantGo, go},
    CommandFunction{app::CommandId::VariantLeave, leave},
};

} // namespace

std::span<const CommandFunction> variantFunctions() { return kVariantFunctions; }

} // namespace rtserver
