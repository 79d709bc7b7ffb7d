#include "common/cli/completion.h"

#include "common/cli/command_names.h"

#include <fmt/core.h>

#include <algorithm>

namespace app {

namespace {

using Words = std::span<const std::string>;

class Completer {
  public:
    Completer(const ProgramSpec& spec, Words words) : spec_(withStandardOptions(spec)), words_(words) {}

    Completion run() {
        readTyped();
        const std::string& current = words_.back();
        if (const Option* option = pending_) {
            value(*option, "", current);
        } else if (!onlyPositionals_ && current.starts_with('-') && current != "-") {
            dashed(current);
        } else {
            if (current == "-" && !onlyPositionals_) spellings();
            positional();
        }
        return std::move(result_);
    }

  private:
    // Which option waits for its value, and which words are no options.
    void readTyped() {
        for (std::size_t i = 0; i + 1 < words_.size(); ++i) {
            const std::string& word = words_[i];
            if (pending_ != nullptr) {
                pending_ = nullptr;
            } else if (onlyPositionals_ || !word.starts_with('-') || word == "-") {
                typed_.push_back(i);
            } else if (word == "--") {
                onlyPositionals_ = true;
            } else if (const Option* option = spelled(word); option != nullptr) {
                if (option->value != ValueKind::None) pending_ = option;
            }
        }
    }

    const Option* spelled(const std::string& word) const {
        for (const OptionGroup& group : spec_.groups) {
            for (const Option& option : group.options) {
                const std::vector<std::string> all = optionSpellings(option);
                if (std::find(all.begin(), all.end(), word) != all.end()) return &option;
            }
        }
        return nullptr;
    }

    void add(const std::string& word) {
        if (word.starts_with(words_.back())) result_.words.push_back(word);
    }

    void dashed(const std::string& current) {
        const std::size_t equals = current.find('=');
        if (equals == std::string::npos) return spellings();
        if (const Option* option = spelled(current.substr(0, equals)))
            value(*option, current.substr(0, equals + 1), current.substr(equals + 1));
    }

    void spellings() {
        for (const OptionGroup& group : spec_.groups) {
            for (const Option& option : group.options) {
                for (const std::string& each : optionSpellings(option)) {
                    const bool goesOn = each.starts_with("--") && option.value != ValueKind::None;
                    add(goesOn ? each + "=" : each);
                }
            }
        }
    }

    void value(const Option& option, const std::string& prefix, const std::string& begun) {
        for (const std::string& choice : option.choices) add(prefix + choice);
        if (option.suggest != nullptr) {
            for (const std::string& each : option.suggest(Words(&begun, 1))) add(prefix + each);
        }
        if (option.argument == "FILE" || !option.files.empty()) files(prefix.size(), option.files);
    }

    void files(std::size_t prefix, const std::vector<std::string>& extensions) {
        result_.files = true;
        result_.prefix = prefix;
        result_.extensions = extensions;
    }

    void positional() {
        if (spec_.positionals.empty()) return;
        const bool commands = std::any_of(spec_.groups.begin(), spec_.groups.end(),
                                          [](const OptionGroup& group) { return !group.words.empty(); });
        if (commands) return command();
        const std::size_t index = typed_.size();
        if (index < spec_.positionals.size()) {
            files(0, spec_.positionals[index].files);
        } else if (spec_.positionals.back().repeats) {
            files(0, spec_.positionals.back().files);
        }
    }

    void command() {
        for (const OptionGroup& group : spec_.groups) {
            for (const HelpWord& word : group.words) command(parseCommandLabel(word.label));
        }
        std::sort(result_.words.begin(), result_.words.end());
        result_.words.erase(std::unique(result_.words.begin(), result_.words.end()), result_.words.end());
    }

    void command(const CommandLabel& label) {
        const std::size_t common = std::min(typed_.size(), label.names.size());
        for (std::size_t i = 0; i < common; ++i) {
            if (words_[typed_[i]] != label.names[i]) return;
        }
        if (typed_.size() < label.names.size()) return add(label.names[typed_.size()]);
        std::size_t index = typed_.size() - label.names.size();
        if (index < label.places.size() && label.places[index] == std::vector<std::string>{"--"}) {
            if (!onlyPositionals_) return add("--");
        }
        // A "--" that was typed is no word of its own.
        for (std::size_t i = 0; i <= index && i < label.places.size(); ++i) {
            if (label.places[i] == std::vector<std::string>{"--"}) ++index;
        }
        if (index >= label.places.size() && label.repeats) index = label.places.size() - 1;
        if (index >= label.places.size()) return;
        for (const std::string& each : label.places[index]) place(label, each);
    }

    void place(const CommandLabel& label, const std::string& text) {
        if (!isPlaceholder(text)) return add(text);
        const Operand* operand = operandOf(label.command(), text);
        if (operand != nullptr && !operand->program.empty()) {
            if (onlyPositionals_) askProgram(operand->program);
        } else if (operand != nullptr && operand->suggest != nullptr) {
            std::vector<std::string> given;
            for (const std::size_t i : typed_) given.push_back(words_[i]);
            given.push_back(words_.back());
            for (const std::string& each : operand->suggest(given)) add(each);
        } else if (text == "FILE" || operand != nullptr) {
            files(0, operand != nullptr ? operand->files : std::vector<std::string>());
        }
    }

    void askProgram(const std::string& name) {
        const auto dashes = std::find(words_.begin(), words_.end(), "--");
        result_.program = name;
        result_.first = static_cast<std::size_t>(dashes - words_.begin()) + 1;
    }

    const Operand* operandOf(const std::string& command, const std::string& name) const {
        const Operand* common = nullptr;
        for (const Operand& operand : spec_.operands) {
            if (operand.name != name) continue;
            if (operand.command == command) return &operand;
            if (operand.command.empty()) common = &operand;
        }
        return common;
    }

    const ProgramSpec spec_;
    Words words_;
    Completion result_;
    const Option* pending_ = nullptr; ///< the option whose value the last word is
    bool onlyPositionals_ = false;    ///< behind "--"
    std::vector<std::size_t> typed_;  ///< the words before the last that are no options
};

} // namespace

Completion completeWords(const ProgramSpec& spec, Words words) {
    if (words.empty()) return {};
    return Completer(spec, words).run();
}

std::string completionText(const Completion& completion) {
    std::string text;
    for (const std::string& word : completion.words) text += "word " + word + "\n";
    if (completion.files) {
        text += fmt::format("files {}", completion.prefix);
        for (const std::string& extension : completion.extensions) text += " " + extension;
        text += "\n";
    }
    if (!completion.program.empty())
        text += fmt::format("program {} {}\n", completion.program, completion.first);
    return text;
}

} // namespace app
